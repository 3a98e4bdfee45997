// Walls: outlines, the layers behind them, and what confines and pushes particles.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "sph/neighbours/particles.hpp"
#include "sph/scheme.hpp"
#include "sph/schemes.hpp"
#include "sph/start/initial_lattice.hpp"
#include "sph/terms/kernels.hpp"
#include "sph/tests/surging_scene.hpp"
#include "sph/walls/outline_layers.hpp"
#include "sph/walls/solid_particles.hpp"
#include "sph/walls/tank_outline.hpp"
#include "sph/walls/wall_contact.hpp"

namespace slosh::sph::outline_test {
namespace {

const TankWalls still_walls{0, 1, 0, 0.7, 0, 0};

TEST(TankOutline, KnowsTheExtentAtEveryHeight) {
  const TankOutline outline(chamfered_outline(0.15));
  EXPECT_NEAR(outline.at(0.05).left, 0.1, 1e-12);
  EXPECT_NEAR(outline.at(0.05).right, 0.9, 1e-12);
  EXPECT_NEAR(outline.at(0.3).width(), 1, 1e-12);
  EXPECT_NEAR(outline.at(0.65).left, 0.1, 1e-12);
}

TEST(TankOutline, GivesTheAreaBetweenTwoHeights) {
  const TankOutline outline(chamfered_outline(0.15));
  EXPECT_NEAR(outline.mean_between(0, 0.35).width() * 0.35, 0.35 - 0.15 * 0.15, 1e-12);
  const TankOutline circle(cylinder_outline());
  EXPECT_NEAR(circle.mean_between(0, circle.top()).width() * circle.top(), 0.25 * std::numbers::pi,
              1e-12);
}

TEST(TankOutline, ContainsWhatIsWithinItsSides) {
  const TankOutline outline(chamfered_outline(0.15));
  EXPECT_TRUE(outline.contains(0.5, 0.01));
  EXPECT_TRUE(outline.contains(0.08, 0.08));
  EXPECT_FALSE(outline.contains(0.07, 0.07));
  EXPECT_FALSE(outline.contains(0.5, -0.01));
  EXPECT_FALSE(outline.contains(0.5, 0.71));
  EXPECT_FALSE(outline.contains(std::nan(""), 0.3));
}

TEST(TankOutline, FindsItsNearestPointWithTheWayIntoTheTank) {
  const TankOutline outline(chamfered_outline(0.15));
  const OutlinePoint chamfer = outline.nearest(0.05, 0.05);
  EXPECT_NEAR(chamfer.at.x, 0.075, 1e-12);
  EXPECT_NEAR(chamfer.at.z, 0.075, 1e-12);
  EXPECT_NEAR(chamfer.inward.x, std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(chamfer.inward.z, std::sqrt(0.5), 1e-12);
  const OutlinePoint corner = outline.nearest(0.16, -0.1);
  EXPECT_NEAR(corner.inward.z, 1, 1e-12);
}

TEST(TankOutline, RefusesWhatIsNoTank) {
  EXPECT_THROW(TankOutline(std::vector<Corner>{{0, 0}, {1, 0}}), std::invalid_argument);
  EXPECT_THROW(TankOutline(std::vector<Corner>{{0, 0}, {0, 1}, {1, 1}, {1, 0}}),
               std::invalid_argument);  // clockwise
  EXPECT_THROW(TankOutline(std::vector<Corner>{{0, 0}, {1, 1}, {1, 0}, {0, 1}}),
               std::invalid_argument);  // sides that cross
  EXPECT_THROW(TankOutline(std::vector<Corner>{{0, 0}, {1, 0}, {1, 1}, {0.5, 0.3}, {0, 1}}),
               std::invalid_argument);  // two basins
  EXPECT_THROW(TankOutline(std::vector<Corner>{{0, 0}, {1, 0}, {1, 0}, {1, 1}, {0, 1}}),
               std::invalid_argument);  // a corner twice
  EXPECT_THROW(TankOutline(std::vector<Corner>{{0, 0}, {1, 0}, {std::nan(""), 1}, {0, 1}}),
               std::invalid_argument);
  EXPECT_NO_THROW(TankOutline(chamfered_outline(0.1)));
}

TEST(OutlineOf, RefusesAnOutlineThatDoesNotTouchTheTanksSides) {
  Scene scene = chamfered_scene(0.05, 0);
  EXPECT_TRUE(outline_of(scene));
  scene.tank_length = 1.2;
  EXPECT_THROW(outline_of(scene), std::invalid_argument);
}

TEST(OutlineOf, RefusesWhatOnlyRectanglesTake) {
  Scene scene = chamfered_scene(0.05, 0);
  scene.obstacles = {{0.4, 0.6, 0, 0.1}};
  EXPECT_THROW(outline_of(scene), std::invalid_argument);
  scene = chamfered_scene(0.05, 0);
  scene.initial_wave = InitialWave{1, 0.01};
  EXPECT_THROW(outline_of(scene), std::invalid_argument);
}

TEST(ConfineTo, ReflectsAParticleThatHasCrossedAnInclinedSide) {
  const TankOutline outline(chamfered_outline(0.15));
  Particles p;
  p.x = {0.07};
  p.z = {0.07};
  p.velocity_x = {-1};
  p.velocity_z = {0};
  EXPECT_EQ(confine_to(outline, p, still_walls), 1);
  EXPECT_NEAR(p.x[0], 0.08, 1e-12);
  EXPECT_NEAR(p.z[0], 0.08, 1e-12);
  // The component along (1, 1) is turned.
  EXPECT_NEAR(p.velocity_x[0], 0, 1e-12);
  EXPECT_NEAR(p.velocity_z[0], 1, 1e-12);
  EXPECT_EQ(confine_to(outline, p, still_walls), 0);
}

// From anywhere near the walls, corners included.
TEST(ConfineTo, LeavesNoParticleOutside) {
  for (const auto& corners : {chamfered_outline(0.15), cylinder_outline(),
                              std::vector<Corner>{{0, 0}, {0.3, 0}, {1, 0.7}, {0, 0.7}}}) {
    const TankOutline outline(corners);
    Particles p;
    for (double x = -0.02; x < 1.02; x += 0.007)
      for (double z = -0.02; z < outline.top() + 0.02; z += 0.007) {
        const OutlinePoint wall = outline.nearest(x, z);
        if (std::hypot(wall.at.x - x, wall.at.z - z) > 0.02) continue;
        p.x.push_back(x);
        p.z.push_back(z);
        p.velocity_x.push_back(0);
        p.velocity_z.push_back(0);
      }
    confine_to(outline, p, still_walls);
    for (std::size_t i = 0; i < p.size(); ++i)
      EXPECT_TRUE(outline.contains(p.x[i], p.z[i])) << p.x[i] << ' ' << p.z[i];
  }
}

constexpr double dp = 0.02, depth = 3 * dp;

std::vector<SolidPlace> layers_of(const std::vector<Corner>& corners) {
  return outline_layers(TankOutline(corners), dp, depth, 2);
}

TEST(OutlineLayers, StandBehindTheSidesHalfASpacingOffAndFartherBack) {
  const TankOutline outline(chamfered_outline(0.15));
  for (const SolidPlace& place : layers_of(chamfered_outline(0.15))) {
    EXPECT_FALSE(outline.contains(place.x, place.z));
    const OutlinePoint wall = outline.nearest(place.x, place.z);
    const double behind = std::hypot(wall.at.x - place.x, wall.at.z - place.z);
    EXPECT_GE(behind, 0.5 * dp - 1e-12);
    EXPECT_LE(behind, depth);
  }
}

// A tank with a side turned into two has the same walls.
TEST(OutlineLayers, OfARectangleAreThoseOfItsLattice) {
  const auto round = layers_of({{0, 0}, {1, 0}, {1, 0.7}, {0, 0.7}});
  Scene scene = still_scene(dp, 0);
  scene.tank_height = 0.7;
  double outline_volume = 0, lattice_volume = 0;
  for (const SolidPlace& place : round) outline_volume += place.cell_share;
  for (const SolidPlace& place : solid_places(scene, true, depth, 2)) {
    // What lies beyond the kernel's reach of a corner is left out here.
    const double off_x = std::max({-place.x, place.x - 1, 0.0}),
                 off_z = std::max({-place.z, place.z - 0.7, 0.0});
    if (std::hypot(off_x, off_z) <= depth) lattice_volume += place.cell_share;
  }
  EXPECT_NEAR(outline_volume, lattice_volume, 0.01 * lattice_volume);
}

TEST(OutlineLayers, LookAtTheirMirrorImagesInTheirSide) {
  const TankOutline outline(chamfered_outline(0.15));
  int in_chamfers = 0;
  for (const SolidPlace& place : layers_of(chamfered_outline(0.15))) {
    EXPECT_TRUE(outline.contains(place.node_x, place.node_z)) << place.x << ' ' << place.z;
    if (place.x + place.z > 0.14 || place.x < 0 || place.z < 0) continue;
    // Behind the lower left chamfer a reflection turns (1, 0) into (0, -1).
    ++in_chamfers;
    EXPECT_NEAR(place.node_x, 0.15 - place.z, 1e-12);
    EXPECT_NEAR(place.node_z, 0.15 - place.x, 1e-12);
    const Vector2 turned = place.turn.of({1, 0}, 0);
    EXPECT_NEAR(turned.x, 0, 1e-12);
    EXPECT_NEAR(turned.z, -1, 1e-12);
  }
  EXPECT_GT(in_chamfers, 10);
}

// Liquid on one side and layers on the other fill a kernel about a point of the wall.
TEST(OutlineLayers, FillTheSpaceBehindSidesAndCorners) {
  for (const auto& corners : {chamfered_outline(0.15), cylinder_outline()}) {
    const TankOutline outline(corners);
    const auto places = layers_of(corners);
    const double h = depth / kernel_support, fine = dp / 10;
    for (const OutlineSide& side : outline.sides())
      for (const Vector2 at :
           {side.from, Vector2{0.5 * (side.from.x + side.to.x), 0.5 * (side.from.z + side.to.z)}}) {
        double filled = 0;
        for (const SolidPlace& b : places)
          filled +=
              b.cell_share * dp * dp * KaiserBessel::shape(std::hypot(b.x - at.x, b.z - at.z) / h);
        for (double x = at.x - depth; x < at.x + depth; x += fine)
          for (double z = at.z - depth; z < at.z + depth; z += fine)
            if (outline.contains(x, z))
              filled += fine * fine * KaiserBessel::shape(std::hypot(x - at.x, z - at.z) / h);
        EXPECT_NEAR(filled * KaiserBessel::normalisation / (h * h), 1, 0.06) << at.x << ' ' << at.z;
      }
  }
}

TEST(Turn, OfBothComponentsIsTheReflectionInAPoint) {
  const Vector2 turned = Turn::both().of({0.3, -0.2}, 0.5);
  EXPECT_NEAR(turned.x, 2 * 0.5 - 0.3, 1e-15);
  EXPECT_NEAR(turned.z, 0.2, 1e-15);
}

TEST(Turn, LeavesWhatMovesWithTheWallAlone) {
  const Vector2 turned = Turn::along(std::sqrt(0.5), std::sqrt(0.5)).of({0.5, 0}, 0.5);
  EXPECT_NEAR(turned.x, 0.5, 1e-15);
  EXPECT_NEAR(turned.z, 0, 1e-15);
}

const TankWalls moving_tank{
    .left = 0.2, .right = 1.2, .bottom = 0, .roof = 1, .velocity = 0.5, .acceleration = 0};

Particles one_particle(double x, double z, double velocity_x, double velocity_z) {
  Particles p;
  p.x = {x};
  p.z = {z};
  p.velocity_x = {velocity_x};
  p.velocity_z = {velocity_z};
  p.density = {1000};
  p.mass = {0.1};
  p.spacing = {0.01};
  return p;
}

void expect_confined(Particles p, double x, double z, double velocity_x, double velocity_z) {
  ReflectingWall(Setting{}).confine(p, moving_tank);
  EXPECT_NEAR(p.x[0], x, 1e-15);
  EXPECT_NEAR(p.z[0], z, 1e-15);
  EXPECT_NEAR(p.velocity_x[0], velocity_x, 1e-15);
  EXPECT_NEAR(p.velocity_z[0], velocity_z, 1e-15);
}

TEST(ReflectingWall, LeavesWhatIsInTheTankAlone) {
  expect_confined(one_particle(0.201, 0.001, -3, -4), 0.201, 0.001, -3, -4);
}

TEST(ReflectingWall, ReflectsWhatCrossedASideWallInTheWallsOwnFrame) {
  expect_confined(one_particle(0.19, 0.5, -1, 0.3), 0.21, 0.5, 2 * 0.5 + 1, 0.3);
  expect_confined(one_particle(1.23, 0.5, 2, 0.3), 1.17, 0.5, 2 * 0.5 - 2, 0.3);
}

TEST(ReflectingWall, ReflectsWhatCrossedTheBottomOrTheRoof) {
  expect_confined(one_particle(0.7, -0.01, 0.1, -2), 0.7, 0.01, 0.1, 2);
  expect_confined(one_particle(0.7, 1.02, 0.1, 2), 0.7, 0.98, 0.1, -2);
}

TEST(ReflectingWall, ReflectsTwiceInACorner) {
  expect_confined(one_particle(0.19, -0.01, -1, -2), 0.21, 0.01, 2, 2);
}

Rates pushed(const Particles& particles, const TankWalls& walls) {
  Rates rates;
  rates.resize(particles.size());
  Setting setting{};
  setting.gravity = 3.4;
  setting.fill_depth = 1;
  setting.flattest_cell = 1;
  RepulsiveWall(setting).push(particles, walls, rates);
  return rates;
}

// Also where the lattice is stretched: at two centimetres it has 18 rows in place of 17.5.
TEST(RepulsiveWall, IsNotFeltByTheStillLatticeOfLisScheme) {
  for (double spacing : {0.025, 0.02, 0.0103, 0.01}) {
    const Scene scene = still_scene(spacing, 0);
    const Scheme<Li2010> scheme(scene);
    const Particles particles =
        initial_lattice(scene, [&](double pressure) { return scheme.state.density(pressure); });
    Rates rates;
    rates.resize(particles.size());
    scheme.wall_contact.push(particles, TankWalls{0, 1, 0, 1, 0, 0}, rates);
    for (std::size_t i = 0; i < particles.size(); ++i) {
      EXPECT_NEAR(rates.acceleration_x[i], 0, 1e-9) << spacing;
      EXPECT_NEAR(rates.acceleration_z[i], 0, 1e-9) << spacing;
    }
  }
}

TEST(RepulsiveWall, PushesInwardsWhatComesNearer) {
  const auto push = [](double x, double z) {
    return pushed(one_particle(x, z, 0, 0), moving_tank);
  };
  EXPECT_GT(push(0.203, 0.5).acceleration_x[0], 0);
  EXPECT_LT(push(1.197, 0.5).acceleration_x[0], 0);
  EXPECT_GT(push(0.7, 0.003).acceleration_z[0], 0);
  EXPECT_LT(push(0.7, 0.997).acceleration_z[0], 0);
  EXPECT_GT(push(0.203, 0.003).acceleration_x[0], 0);
  EXPECT_GT(push(0.203, 0.003).acceleration_z[0], 0);
  EXPECT_EQ(push(0.206, 0.006).acceleration_x[0], 0);
}

// Right above a wall particle, the others being out of range, D = 5 g h: D ((r0/r)^12 - (r0/r)^4) /
// r.
TEST(RepulsiveWall, HasMonaghansForceFromTheNearestWallParticle) {
  const double r = 0.004, ratio = 0.005 / r;
  const double expected = 17 * (std::pow(ratio, 12) - std::pow(ratio, 4)) / r;
  const Rates rates = pushed(one_particle(0.2 + 100 * 0.005, r, 0, 0), moving_tank);
  EXPECT_NEAR(rates.acceleration_z[0], expected, 1e-9 * expected);
  EXPECT_NEAR(rates.acceleration_x[0], 0, 1e-9 * expected);
}

TEST(RepulsiveWall, PushesTheHarderTheNearer) {
  double last = 0;
  for (double distance : {0.0049, 0.004, 0.003, 0.002}) {
    const double push =
        pushed(one_particle(0.2 + distance, 0.5, 0, 0), moving_tank).acceleration_x[0];
    EXPECT_GT(push, last);
    last = push;
  }
}

}  // namespace
}  // namespace slosh::sph::outline_test

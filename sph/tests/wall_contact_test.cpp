#include "sph/walls/wall_contact.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "sph/scheme.hpp"
#include "sph/schemes.hpp"
#include "sph/start/initial_lattice.hpp"
#include "sph/tests/surging_scene.hpp"

namespace slosh::sph::wall_contact_test {
namespace {

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
}  // namespace slosh::sph::wall_contact_test

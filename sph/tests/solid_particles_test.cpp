#include "sph/walls/solid_particles.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "sph/neighbours/neighbour_sources.hpp"
#include "sph/scheme.hpp"
#include "sph/schemes.hpp"
#include "sph/terms/kernels.hpp"
#include "sph/tests/disordered_liquid.hpp"
#include "sph/tests/surging_scene.hpp"
#include "sph/walls/node_sums.hpp"
#include "sph/walls/obstacle_contact.hpp"
#include "sph/walls/solids.hpp"
#include "verification/tests/messages.hpp"

namespace slosh::sph::solid_particles_test {
namespace {

constexpr double dp = 0.05, depth = 0.15;  // three layers

Scene scene_with(std::vector<Rectangle> obstacles) {
  Scene scene = still_scene(dp, 0);
  scene.tank_height = 0.5;
  scene.obstacles = std::move(obstacles);
  return scene;
}

bool in_tank(double x, double z) { return x > 0 && x < 1 && z > 0 && z < 0.5; }

// A multiple of half a spacing that is no multiple of a whole one.
void expect_in_the_middle_of_a_cell(const SolidPlace& place) {
  EXPECT_NEAR(std::remainder(place.x - dp / 2, dp), 0, 1e-12);
  EXPECT_NEAR(std::remainder(place.z - dp / 2, dp), 0, 1e-12);
}

void expect_no_two_at_one_place(const std::vector<SolidPlace>& places) {
  for (std::size_t i = 0; i < places.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      EXPECT_GT(std::hypot(places[i].x - places[k].x, places[i].z - places[k].z), 0.5 * dp);
}

TEST(SolidPlaces, SurroundTheTankWithWholeLayers) {
  const std::vector<SolidPlace> places = solid_places(scene_with({}), true, depth, 1);
  EXPECT_EQ(places.size(), 26 * 16 - 20 * 10);
  for (const SolidPlace& place : places) {
    EXPECT_FALSE(in_tank(place.x, place.z));
    EXPECT_TRUE(place.x > -depth && place.x < 1 + depth && place.z > -depth &&
                place.z < 0.5 + depth);
    expect_in_the_middle_of_a_cell(place);
  }
  EXPECT_EQ(solid_places(scene_with({}), true, 2.1 * dp, 1).size(), 26 * 16 - 20 * 10);
  EXPECT_TRUE(solid_places(scene_with({}), false, depth, 1).empty());
}

TEST(SolidPlaces, OfTheTanksWallsLookAtTheirMirrorImages) {
  for (const SolidPlace& place : solid_places(scene_with({}), true, depth, 1)) {
    EXPECT_EQ(place.turn.xx < 0, place.x < 0 || place.x > 1);
    EXPECT_EQ(place.turn.zz < 0, place.z < 0 || place.z > 0.5);
    EXPECT_NEAR(place.node_x, place.x < 0 ? -place.x : place.x > 1 ? 2 - place.x : place.x, 1e-12);
    EXPECT_NEAR(place.node_z,
                place.z < 0     ? -place.z
                : place.z > 0.5 ? 1 - place.z
                                : place.z,
                1e-12);
  }
}

// Each cell of a wall holds three places, and each cell of a corner nine.
TEST(SolidPlaces, StandCloserAlongTheWallsWithTheSameVolume) {
  const auto places = solid_places(scene_with({}), true, depth, 3);
  EXPECT_EQ(places.size(), 3 * (2 * 3 * (20 + 10)) + 9 * (4 * 3 * 3));
  double cells = 0;
  for (const SolidPlace& place : places) {
    cells += place.cell_share;
    EXPECT_FALSE(in_tank(place.x, place.z));
    EXPECT_TRUE(in_tank(place.node_x, place.node_z));
    EXPECT_NEAR(place.node_x, place.x < 0 ? -place.x : place.x > 1 ? 2 - place.x : place.x, 1e-12);
    const auto off_thirds = [](double at) { return std::remainder(at - dp / 6, dp / 3); };
    EXPECT_NEAR(place.turn.xx < 0 ? off_thirds(place.z) : 0, 0, 1e-12);
    EXPECT_NEAR(place.turn.zz < 0 ? off_thirds(place.x) : 0, 0, 1e-12);
  }
  EXPECT_NEAR(cells, 26 * 16 - 20 * 10, 1e-9);
}

TEST(SolidPlaces, FillAnObstacleAndLookAcrossItsNearestFace) {
  const Rectangle r{0.3, 0.6, 0.15, 0.35};
  const std::vector<SolidPlace> places = solid_places(scene_with({r}), false, depth, 1);
  EXPECT_EQ(places.size(), 6 * 4);
  for (const SolidPlace& place : places) {
    EXPECT_TRUE(holds(r, place.x, place.z));
    expect_in_the_middle_of_a_cell(place);
    EXPECT_TRUE(in_tank(place.node_x, place.node_z));
    EXPECT_NE(place.turn.xx, place.turn.zz);
    const double nearest =
        std::min({place.x - r.left, r.right - place.x, place.z - r.bottom, r.top - place.z});
    EXPECT_NEAR(std::abs(place.node_x - place.x), place.turn.xx < 0 ? 2 * nearest : 0, 1e-12);
    EXPECT_NEAR(std::abs(place.node_z - place.z), place.turn.zz < 0 ? 2 * nearest : 0, 1e-12);
    EXPECT_FALSE(holds(r, place.node_x, place.node_z));
  }
}

TEST(SolidPlaces, LeaveOutWhatIsTooDeepInAnObstacleForTheLiquidToReach) {
  // 12 columns of cells, of which 6 are deeper than three layers, and 10 + 2 x 3 rows.
  EXPECT_EQ(solid_places(scene_with({{0.2, 0.8, 0, 0.5}}), false, depth, 1).size(), 6U * 16);
  EXPECT_EQ(solid_places(scene_with({{0.2, 0.8, -9, 9}}), false, depth, 1).size(), 6U * 16);
}

class ObstacleAtAWall : public testing::TestWithParam<Rectangle> {};
INSTANTIATE_TEST_SUITE_P(OfTheTank, ObstacleAtAWall,
                         testing::Values(Rectangle{0.4, 0.6, 0, 0.2}, Rectangle{0.4, 0.6, 0.3, 0.5},
                                         Rectangle{0, 0.2, 0, 0.2}, Rectangle{0.8, 1, 0.2, 0.35},
                                         Rectangle{0.4, 0.55, 0, 0.1}));

TEST_P(ObstacleAtAWall, ContinuesBehindItInPlaceOfTheWallsOwnLayers) {
  const Rectangle r = obstacles_on_lattice(scene_with({GetParam()}), depth)[0];
  EXPECT_NEAR(r.bottom, GetParam().bottom == 0 ? -depth : GetParam().bottom, 1e-12);
  EXPECT_NEAR(r.top, GetParam().top == 0.5 ? 0.5 + depth : GetParam().top, 1e-12);
  EXPECT_NEAR(r.left, GetParam().left == 0 ? -depth : GetParam().left, 1e-12);
  EXPECT_NEAR(r.right, GetParam().right == 1 ? 1 + depth : GetParam().right, 1e-12);
  for (const bool tank_walls : {false, true}) {
    const auto places = solid_places(scene_with({GetParam()}), tank_walls, depth, 1);
    expect_no_two_at_one_place(places);
    const auto behind = std::count_if(places.begin(), places.end(), [&](const SolidPlace& place) {
      return holds(r, place.x, place.z) && !in_tank(place.x, place.z);
    });
    EXPECT_GT(behind, 0);
  }
}

TEST_P(ObstacleAtAWall, LooksAtTheLiquidAlone) {
  const Rectangle r = obstacles_on_lattice(scene_with({GetParam()}), depth)[0];
  for (const SolidPlace& place : solid_places(scene_with({GetParam()}), false, depth, 1)) {
    EXPECT_TRUE(in_tank(place.node_x, place.node_z)) << place.node_x << ' ' << place.node_z;
    EXPECT_FALSE(holds(r, place.node_x, place.node_z)) << place.node_x << ' ' << place.node_z;
  }
}

// The layers stay in step with the lattice where the kernel reaches across no whole number of them.
TEST(SolidPlaces, StayHalfASpacingInsideTheFacesWhateverTheDepth) {
  for (const double reach : {0.1, 0.11, 0.15})
    for (const SolidPlace& place : solid_places(scene_with({{0.4, 0.6, 0, 0.2}}), true, reach, 1))
      expect_in_the_middle_of_a_cell(place);
}

TEST(ObstaclesOnLattice, HaveTheirEdgesOnTheNearestBorderBetweenCells) {
  const Rectangle r = obstacles_on_lattice(scene_with({{0.32, 0.61, 0.13, 0.33}}), depth)[0];
  EXPECT_NEAR(r.left, 0.3, 1e-12);
  EXPECT_NEAR(r.right, 0.6, 1e-12);
  EXPECT_NEAR(r.bottom, 0.15, 1e-12);
  EXPECT_NEAR(r.top, 0.35, 1e-12);
}

// 27 columns in place of 27.4, 10 rows of liquid in place of 9.6.
TEST(ObstaclesOnLattice, FollowTheCellsOfAStretchedLattice) {
  Scene scene = still_scene(0.0365, 0);
  scene.obstacles = {{0.68, 1, 0, 0.2}};
  const Rectangle r = obstacles_on_lattice(scene, 0)[0];
  EXPECT_NEAR(r.left, 18 / 27.0, 1e-12);
  EXPECT_EQ(r.right, 1);
  EXPECT_NEAR(r.top, 6 * 0.035, 1e-12);
}

std::string refusal_of(const Rectangle& obstacle) {
  return message_of<std::invalid_argument>(
      [&] { solid_places(scene_with({obstacle}), false, depth, 1); });
}

TEST(ObstaclesOnLattice, RefuseOneThinnerThanAParticleSpacing) {
  const std::string refusal = refusal_of({0.42, 0.46, 0, 0.3});
  for (const char* part : {"obstacle", "0.42 to 0.46 m", "0 to 0.3 m", "expected",
                           "at least as thick as a particle spacing, 0.05 m"})
    EXPECT_TRUE(slosh::holds(refusal, part)) << part << " is not in ";
  EXPECT_NE(refusal_of({0.3, 0.6, 0.2, 0.249}), "");  // thin and hanging in the liquid
  EXPECT_NE(refusal_of({0.6, 0.3, 0.1, 0.3}), "");    // right before left
  EXPECT_NE(refusal_of({0.3, 0.31, 0.1, 0.3}), "");   // snapped to nothing
  EXPECT_NE(refusal_of({std::nan(""), 0.5, 0, 0.3}), "");
  EXPECT_EQ(refusal_of({0.3, 0.35, 0, 0.3}), "");
  // Behind a wall there is no liquid to meet.
  EXPECT_EQ(refusal_of({0.3, 0.6, 0, 0.05}), "");
  EXPECT_EQ(refusal_of({0, 0.05, 0, 0.3}), "");
}

Particles particle_at(double x, double z) {
  Particles p;
  p.x = {x};
  p.z = {z};
  p.velocity_x = {0.7};
  p.velocity_z = {-0.4};
  return p;
}

const TankWalls moving_walls{
    .left = 0.2, .right = 1.2, .bottom = 0, .roof = 0.5, .velocity = 0.5, .acceleration = 0};

void expect_expelled(double x, double z, double to_x, double to_z, double u, double w) {
  Particles p = particle_at(0.2 + x, z);
  // As obstacles_on_lattice has it: continued behind the bottom.
  expel(p, moving_walls, {0.4, 0.6, -depth, 0.2});
  EXPECT_NEAR(p.x[0], 0.2 + to_x, 1e-12);
  EXPECT_NEAR(p.z[0], to_z, 1e-12);
  EXPECT_NEAR(p.velocity_x[0], u, 1e-12);
  EXPECT_NEAR(p.velocity_z[0], w, 1e-12);
}

TEST(Expel, BringsAParticleOutThroughTheNearestFaceWithItsNormalVelocityTurned) {
  expect_expelled(0.41, 0.1, 0.39, 0.1, 2 * 0.5 - 0.7, -0.4);
  expect_expelled(0.58, 0.1, 0.62, 0.1, 2 * 0.5 - 0.7, -0.4);
  expect_expelled(0.5, 0.19, 0.5, 0.21, 0.7, 0.4);
}

TEST(Expel, LeavesAloneWhatIsOutside) {
  expect_expelled(0.39, 0.1, 0.39, 0.1, 0.7, -0.4);
  expect_expelled(0.5, 0.21, 0.5, 0.21, 0.7, -0.4);
}

TEST(Expel, NeverBringsAParticleOutThroughTheTanksBottom) {
  Particles p = particle_at(0.2 + 0.5, 0.01);
  expel(p, moving_walls, {0.1, 0.9, -0.05, 0.4});
  EXPECT_GT(p.z[0], 0);
}

TEST(NeighbourSources, LeaveOutImagesInsideObstacles) {
  // One particle beside the obstacle, whose image in the bottom would lie in it, and one whose
  // image lies behind the bottom, in the tank's wall.
  const TankWalls walls{0, 1, 0, 0.5, 0, 0};
  const auto sources_beside = [&](const std::vector<Rectangle>& obstacles) {
    NeighbourSources sources(walls, dp, depth);
    std::vector<SolidPlace> none;
    sources.add_solids(none, obstacles);
    Particles particles = particle_at(0.55, 0.02);
    particles.for_each_field([](auto& field) { field.push_back(field[0]); });
    particles.x[1] = 0.35;
    EXPECT_TRUE(sources.rebuild(particles, walls, 0, true));
    return sources.source_count();
  };
  EXPECT_EQ(sources_beside({}), 4);
  EXPECT_EQ(sources_beside({{0.5, 0.6, -depth, 0}}), 3);
}

constexpr double support = 0.03;  // of the recommended scheme at this spacing

double linear_field(double x, double z) { return 3 + 40 * x - 70 * z; }

class NodeSums : public testing::Test {
 protected:
  // The sums at places of the tank at rest over the particles, without images or solids.
  Nodes sums(Particles particles, std::vector<SolidPlace> places) {
    NeighbourSources neighbours(tank_at_rest, small_spacing, support);
    neighbours.add_solids(places, {});
    EXPECT_TRUE(neighbours.rebuild(particles, tank_at_rest, 0, false));
    neighbours.refresh_for_momentum(scheme_, particles, tank_at_rest);
    // The evaluated field does not enter the weights.
    Nodes found;
    for (const InstructionSet set :
         {InstructionSet::plain, InstructionSet::avx2, InstructionSet::avx512}) {
      if (!has(set)) continue;
      found.place(places);
      sum_at_nodes<WithGhostWalls::Kernel>(NodeValue::density, scheme_.setting.smoothing_length(),
                                           neighbours, tank_at_rest, found, set);
      for (std::size_t i = 0; i < places.size(); ++i) check(found, i);
    }
    return found;
  }

  void check(const Nodes& nodes, std::size_t i) {
    if (!expect_linear_) return;
    ASSERT_TRUE(nodes.found(i));
    const double expected = linear_field(nodes.x[i], nodes.z[i]);
    EXPECT_NEAR(nodes.value[i], expected, 1e-11);
    EXPECT_NEAR(nodes.velocity_x[i], 0.1 * expected, 1e-12);
    EXPECT_NEAR(nodes.velocity_z[i], -0.2 * expected, 1e-12);
  }

  // Density and velocity linear in space.
  static Particles with_linear_fields(Particles p) {
    for (std::size_t i = 0; i < p.size(); ++i) {
      p.density[i] = linear_field(p.x[i], p.z[i]);
      p.velocity_x[i] = 0.1 * p.density[i];
      p.velocity_z[i] = -0.2 * p.density[i];
      p.mass[i] = 1e-4 * p.density[i];
    }
    return p;
  }

  static SolidPlace node_at(double x, double z) { return {-0.005, z, x, z, {true, false}}; }

  const Scheme<WithGhostWalls> scheme_{small_scene()};
  bool expect_linear_ = false;
};

TEST_F(NodeSums, ReproduceALinearFieldInFullAndHalfSupports) {
  expect_linear_ = true;
  std::vector<SolidPlace> places;
  for (double along : {0.0, 0.001, 0.013, 0.05, 0.08, 0.1, 0.147, 0.16}) {
    places.push_back(node_at(along, 0.08));
    places.push_back(node_at(0.1, along));
  }
  sums(with_linear_fields(full_tank(tank_at_rest)), places);
}

// Two particles carry no plane: the weights are those of the kernel alone.
TEST_F(NodeSums, AreThePlainMeanInASplash) {
  DisorderedLiquid splash(tank_at_rest);
  splash.add(0.09, 0.08, small_spacing);
  splash.add(0.112, 0.08, small_spacing);
  Particles p = splash.particles;
  p.density = {900, 1100};
  p.velocity_x = {1, 3};
  p.velocity_z = {-2, 0};
  p.mass = {0.09, 0.11};  // equal volumes
  const Nodes half = sums(p, {node_at(0.101, 0.08)});
  ASSERT_TRUE(half.found(0));
  EXPECT_NEAR(half.value[0], 1000, 1e-9);
  EXPECT_NEAR(half.velocity_x[0], 2, 1e-12);
  EXPECT_NEAR(half.velocity_z[0], -1, 1e-12);
  const double near = Recommended::Kernel::shape(0.004 / 0.015),
               far = Recommended::Kernel::shape(0.018 / 0.015);
  const Nodes nearer = sums(p, {node_at(0.094, 0.08)});
  EXPECT_NEAR(nearer.value[0], (near * 900 + far * 1100) / (near + far), 1e-9);
}

TEST_F(NodeSums, FindNothingWhereTheSupportIsEmpty) {
  DisorderedLiquid drop(tank_at_rest);
  drop.add(0.1, 0.08, small_spacing);
  const Nodes found =
      sums(drop.particles, {node_at(0.1, 0.1101), node_at(0.02, 0.08), node_at(0.1, 0.1095)});
  for (std::size_t i = 0; i < found.size(); ++i) {
    const bool reached = found.z[i] == 0.1095;
    EXPECT_EQ(found.found(i), reached);
    EXPECT_EQ(found.value[i] != 0, reached);
  }
}

}  // namespace
}  // namespace slosh::sph::solid_particles_test

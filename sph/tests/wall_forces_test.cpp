// The forces by wall, for every way in which a scheme makes its walls.
#include <gtest/gtest.h>

#include <cmath>

#include "sph/tests/rolling_scene.hpp"

namespace slosh::sph::wall_forces_test {
namespace {

const std::vector<LoadedWall> four_walls{
    {"left", Wall::left}, {"right", Wall::right}, {"bottom", Wall::bottom}, {"roof", Wall::roof}};

struct Walls {
  std::string scheme, variant;
};

// Images, images with friction, repulsive particles, and walls made of particles in two ways.
const std::vector<Walls> kinds{{"recommended", ""},
                               {"recommended", "no_slip_mirror"},
                               {"li2010", ""},
                               {"recommended", "ghost_walls"},
                               {"recommended", "dynamic_walls"}};

double sum_of(const std::map<std::string, History>& forces, std::size_t sample) {
  double sum = 0;
  for (const auto& [wall, history] : forces) sum += history.value.at(sample);
  return sum;
}

void expect_sums(const RunOutput& output, const std::string& of) {
  ASSERT_EQ(output.wall_force_x.size(), 4u) << of;
  const double weight = std::abs(output.force_z.value.front());
  for (std::size_t i = 0; i < output.force_x.time.size(); ++i) {
    EXPECT_NEAR(sum_of(output.wall_force_x, i), output.force_x.value[i], 1e-9 * weight) << of;
    EXPECT_NEAR(sum_of(output.wall_force_z, i), output.force_z.value[i], 1e-9 * weight) << of;
  }
}

TEST(WallForces, AddUpToThatOnASurgingTank) {
  for (const Walls& kind : kinds) {
    Scene scene = surging_scene(0.05, 0.03);
    scene.variant = kind.variant;
    scene.loaded_walls = four_walls;
    expect_sums(run(kind.scheme, scene, {}), kind.scheme + " " + kind.variant);
  }
}

// The tank's axes turn against the earth's, in which zhao2021_moving follows the particles.
TEST(WallForces, AddUpToThatOnARollingTankInBothFrames) {
  for (const char* scheme : {"recommended", "zhao2021_moving"}) {
    Scene scene = surging_and_rolling_scene(0.03, 0.06);
    scene.loaded_walls = four_walls;
    expect_sums(run(scheme, scene, {}), scheme);
  }
}

// The pressure on a side wall grows to rho g h at the bottom.
TEST(WallForces, AreHydrostaticInStillWater) {
  for (const char* scheme : {"recommended", "li2010"}) {
    Scene scene = still_scene(0.02, 0.02);
    scene.loaded_walls = four_walls;
    const RunOutput output = run(scheme, scene, {});
    const double side = 9810 * 0.35 * 0.35 / 2, weight = 9810 * 0.35;
    EXPECT_NEAR(output.wall_force_x.at("left").value.back(), -side, 0.1 * side) << scheme;
    EXPECT_NEAR(output.wall_force_x.at("right").value.back(), side, 0.1 * side) << scheme;
    EXPECT_NEAR(output.wall_force_z.at("bottom").value.back(), -weight, 0.03 * weight) << scheme;
    EXPECT_EQ(output.wall_force_z.at("roof").value.back(), 0) << scheme;
  }
}

TEST(WallForces, AreRecordedOnlyOfTheWallsThatTheSceneNames) {
  Scene scene = still_scene(0.05, 0.02);
  EXPECT_TRUE(run("recommended", scene, {}).wall_force_x.empty());
  scene.loaded_walls = {{"right", Wall::right}};
  const RunOutput output = run("recommended", scene, {});
  EXPECT_EQ(output.wall_force_x.size(), 1u);
  EXPECT_EQ(output.wall_force_x.at("right").time, output.force_x.time);
}

}  // namespace
}  // namespace slosh::sph::wall_forces_test

// A tank's flow is the same whether it is solved in the frame of the earth or in the tank's.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "sph/simulation.hpp"
#include "sph/tests/rolling_scene.hpp"

namespace slosh::sph::both_frames_test {
namespace {

double largest_difference(const History& a, const History& b) {
  double largest = 0;
  EXPECT_EQ(a.time, b.time);
  for (std::size_t i = 0; i < a.value.size(); ++i)
    largest = std::max(largest, std::abs(a.value[i] - b.value[i]));
  return largest;
}
double swing(const History& history) {
  const auto [low, high] = std::minmax_element(history.value.begin(), history.value.end());
  return *high - *low;
}

// Surge and roll together, half a second, the liquid at rest in the tank or in the earth first.
TEST(Zhao2021, GivesTheSameFlowWithMovingWallsAndInTheTanksFrame) {
  for (const Start start : {Start::tank, Start::earth}) {
    Scene scene = surging_and_rolling_scene(0.02, 0.5);
    scene.start = start;
    const RunOutput moving = run("zhao2021_moving", scene, {}),
                    fixed = run("zhao2021_fixed", scene, {});
    EXPECT_LE(largest_difference(moving.elevation.at("left"), fixed.elevation.at("left")),
              1e-3 * swing(fixed.elevation.at("left")));
    EXPECT_LE(largest_difference(moving.wall_pressure.at("B"), fixed.wall_pressure.at("B")),
              1e-2 * swing(fixed.wall_pressure.at("B")));
    EXPECT_LE(largest_difference(moving.force_x, fixed.force_x), 1e-2 * swing(fixed.force_x));
    EXPECT_LE(largest_difference(moving.force_z, fixed.force_z), 1e-2 * swing(fixed.force_z));
    EXPECT_LE(largest_difference(moving.moment, fixed.moment), 1e-2 * swing(fixed.moment));
    EXPECT_LE(largest_difference(moving.kinetic_energy, fixed.kinetic_energy),
              1e-3 * swing(fixed.kinetic_energy));
    EXPECT_LE(largest_difference(moving.momentum_x, fixed.momentum_x),
              1e-3 * swing(fixed.momentum_x));
  }
}

class MirrorScheme : public testing::TestWithParam<std::string> {
 protected:
  static Scene with_variant(Scene scene) {
    scene.variant = GetParam();
    scene.kinematic_viscosity = 1e-3;  // a Stokes layer as thick as a spacing
    return scene;
  }
};
INSTANTIATE_TEST_SUITE_P(Variant, MirrorScheme,
                         testing::Values("", "laminar_viscosity", "no_slip_mirror",
                                         "no_slip_laminar"),
                         [](const auto& variant) {
                           return variant.param.empty() ? "recommended" : variant.param;
                         });

// A mirror scheme has its surge in the frame of the earth, and in the tank's where that rolls too.
// The walls move in the one and stand in the other, and the images' velocities with them.
TEST_P(MirrorScheme, GivesTheSameSurgeInBothFrames) {
  Scene scene = with_variant(surging_scene(0.025, 0.5));
  scene.pressure_gauges = {{"B", Wall::left, 0.1, 0}};
  const RunOutput earth = run("recommended", scene, {});
  scene.roll = no_roll();
  const RunOutput tank = run("recommended", scene, {});
  EXPECT_LE(largest_difference(earth.elevation.at("left"), tank.elevation.at("left")),
            1e-3 * swing(earth.elevation.at("left")));
  EXPECT_LE(largest_difference(earth.wall_pressure.at("B"), tank.wall_pressure.at("B")),
            1e-2 * swing(earth.wall_pressure.at("B")));
  EXPECT_LE(largest_difference(earth.force_x, tank.force_x), 1e-2 * swing(earth.force_x));
}

TEST_P(MirrorScheme, Rolls) {
  const Scene scene = with_variant(surging_and_rolling_scene(0.02, 0.1));
  const RunOutput output = run("recommended", scene, {});
  EXPECT_GT(swing(output.elevation.at("left")), 1e-4);
}

}  // namespace
}  // namespace slosh::sph::both_frames_test

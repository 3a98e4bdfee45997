// The forces by wall, for every way in which a scheme makes its walls.
#include <gtest/gtest.h>

#include <cmath>

#include "sph/tests/named_schemes.hpp"
#include "sph/tests/surging_scene.hpp"

namespace slosh::sph::wall_forces_test {
namespace {

// The tank's axes turn against the earth's, in which zhao2021_moving follows the particles.
TEST(WallForces, AddUpToThatOnARollingTankInBothFrames) {
  for (const char* scheme : {"recommended", "zhao2021_moving"}) {
    Scene scene = surging_and_rolling_scene(0.03, 0.06);
    scene.loaded_walls = four_walls;
    expect_walls_to_add_up(run(scheme, scene, {}));
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

// A trapezoid whose walls lean outward, 0.4 m wide at the bottom and 1 m at its top of 0.6 m.
Scene leaning_scene(double particle_spacing, double duration) {
  Scene scene = still_scene(particle_spacing, duration);
  scene.tank_height = 0.6;
  scene.outline = {{0.3, 0}, {0.7, 0}, {1, 0.6}, {0, 0.6}};
  return scene;
}

// Expects the mean of the last tenth of the run, in which the particles' own noise is small.
void expect_mean(const History& history, double expected, double tolerance, const char* of) {
  double sum = 0;
  const std::size_t count = history.value.size() / 10 + 1;
  for (std::size_t i = history.value.size() - count; i < history.value.size(); ++i)
    sum += history.value[i];
  EXPECT_NEAR(sum / static_cast<double>(count), expected, tolerance) << of;
}

// Pressure acts on the projections of an inclined side: what faces left is a wall of the whole
// depth, and what faces down bears the whole weight.
TEST(WallForces, AreHydrostaticBetweenInclinedSides) {
  for (const Scene& still : {chamfered_scene(0.02, 0.1), leaning_scene(0.02, 0.1)}) {
    Scene scene = still;
    scene.loaded_walls = four_walls;
    const RunOutput output = run("recommended", scene, {});
    expect_walls_to_add_up(output);
    const double depth = 0.35, side = 9810 * depth * depth / 2;
    const bool leans = scene.outline.size() == 4;
    const double area = leans ? depth * (0.4 + 0.5 * depth) : depth - 0.15 * 0.15;
    const double weight = 9810 * area;
    expect_mean(output.wall_force_x.at("left"), -side, 0.05 * side, "left");
    expect_mean(output.wall_force_x.at("right"), side, 0.05 * side, "right");
    expect_mean(output.wall_force_z.at("bottom"), -weight, 0.01 * weight, "bottom");
    expect_mean(output.wall_force_z.at("roof"), 0, 1e-9 * weight, "roof");
    expect_mean(output.force_x, 0, 1e-3 * weight, "both sides");
  }
}

// The same liquid in a rectangle and in an outline whose chamfers are a tenth of a spacing.
TEST(WallForces, OfTinyChamfersAreThoseOfARectangle) {
  Scene box = surging_scene(0.04, 0.3);
  box.variant = "ghost_walls";
  box.tank_height = 0.7;
  box.loaded_walls = four_walls;
  Scene outlined = box;
  outlined.variant.clear();
  outlined.outline = chamfered_outline(0.004);
  const RunOutput expected = run("recommended", box, {}), found = run("recommended", outlined, {});
  const double side = 9810 * 0.35 * 0.35 / 2, weight = 9810 * 0.35;
  for (const char* wall : {"left", "right"})
    expect_mean(found.wall_force_x.at(wall), expected.wall_force_x.at(wall).value.back(),
                0.03 * side, wall);
  expect_mean(found.wall_force_z.at("bottom"), expected.wall_force_z.at("bottom").value.back(),
              0.01 * weight, "bottom");
}

// The moment about the axis of a roll that does not move is that of the liquid's weight.
TEST(WallForces, OfAChamferedTankHaveTheMomentOfItsWeight) {
  Scene scene = chamfered_scene(0.02, 0.1);
  scene.roll = Roll{[](double) { return 0.0; }, [](double) { return 0.0; },
                    [](double) { return 0.0; }, 0.1, 0.05};
  const double weight = 9810 * (0.35 - 0.15 * 0.15);
  expect_mean(run("recommended", scene, {}).moment, -0.4 * weight, 0.01 * 0.4 * weight, "moment");
}

TEST(WallForces, AreRecordedOnlyOfTheWallsThatTheSceneNames) {
  Scene scene = still_scene(0.05, 0.02);
  EXPECT_TRUE(run("recommended", scene, {}).wall_force_x.empty());
  scene.loaded_walls = {{"right", Wall::right}};
  const RunOutput output = run("recommended", scene, {});
  EXPECT_EQ(output.wall_force_x.size(), 1u);
  EXPECT_EQ(output.wall_force_x.at("right").time, output.force_x.time);
}

// At the start of a run whose liquid has not moved yet the weight is what the walls bear.
TEST(Forces, BearTheWeightOfALiquidThatRestsInARollingTankAndItsMomentAboutTheAxis) {
  Scene scene = surging_and_rolling_scene(0.02, 0.02);
  for (auto* function : {&scene.displacement, &scene.velocity, &scene.acceleration})
    *function = [](double) { return 0.0; };
  scene.roll = no_roll();
  scene.roll->axis_x = 0.3;
  for (const char* scheme : {"recommended", "li2010", "delta_sph"}) {
    const RunOutput output = run(scheme, scene, {});
    const double weight = 1000 * 9.81 * 0.8 * 0.24;
    EXPECT_NEAR(output.force_z.value.back(), -weight, 0.03 * weight) << scheme;
    EXPECT_NEAR(output.force_x.value.back(), 0, 0.002 * weight) << scheme;
    EXPECT_NEAR(output.moment.value.back(), -weight * 0.1, 0.03 * weight * 0.1) << scheme;
  }
}

}  // namespace
}  // namespace slosh::sph::wall_forces_test

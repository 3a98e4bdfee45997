// A tank that is no rectangle, and a sensor in the roof, as each solver receives them.
#include <gtest/gtest.h>

#include "sph/simulation.hpp"
#include "verification/case/gap_friction.hpp"
#include "verification/peers/interfoam_tank.hpp"
#include "verification/solvers/sph_scene.hpp"
#include "verification/tests/sample_case.hpp"

namespace slosh::tank_translation_test {
namespace {

template <class Corners>
void expect_corners(const Corners& corners, const std::vector<Corner>& wanted) {
  ASSERT_EQ(corners.size(), wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    EXPECT_EQ(corners[i].x, wanted[i].x);
    EXPECT_EQ(corners[i].z, wanted[i].z);
  }
}

TEST(OutlineTranslation, GivesBothSolversTheCorners) {
  CaseDefinition definition = sample_case();
  definition.tank.outline = {{0.2, 0}, {0.8, 0}, {1, 1}, {0, 1}};
  const sph::Scene scene = sph_scene(definition, {"recommended", 0.02, 0.02});
  expect_corners(scene.outline, definition.tank.outline);
  EXPECT_EQ(scene.tank_length, 1);
  const openfoam::SloshingTank tank = interfoam_tank({.cells_x = 50, .cells_z = 50}, definition);
  expect_corners(tank.outline, definition.tank.outline);
  EXPECT_EQ(tank.height, 1);
}

TEST(OutlineTranslation, OfARectangleIsNone) {
  EXPECT_TRUE(sph_scene(sample_case(), {"recommended", 0.02, 0.02}).outline.empty());
  EXPECT_TRUE(interfoam_tank({.cells_x = 50, .cells_z = 50}, sample_case()).outline.empty());
}

TEST(SensorTranslation, KnowsTheRoof) {
  CaseDefinition definition = sample_case();
  definition.pressure_gauges = {{"top", Wall::roof, 0.3, 0.01}};
  const sph::Scene scene = sph_scene(definition, {"recommended", 0.02, 0.02});
  ASSERT_EQ(scene.pressure_gauges.size(), 1u);
  EXPECT_EQ(scene.pressure_gauges[0].wall, sph::Wall::roof);
  EXPECT_EQ(scene.pressure_gauges[0].position, 0.3);
  EXPECT_EQ(scene.pressure_gauges[0].width, 0.01);
}

// A narrow tank as OpenFOAM receives it, in two dimensions and in three.

TEST(GapTranslation, GivesAPorousMediumInTwoDimensionsAndHalfOfTheGapInThree) {
  CaseDefinition definition = sample_case();
  definition.tank.breadth = 0.062;
  InterFoamRun run{.cells_x = 50, .cells_z = 40};
  run.no_slip = true;
  const openfoam::SloshingTank plane = interfoam_tank(run, definition);
  EXPECT_EQ(plane.gap_friction, gap_friction(definition));
  EXPECT_FALSE(plane.gap);
  run.cells_y = 8;
  const openfoam::SloshingTank across = interfoam_tank(run, definition);
  EXPECT_EQ(across.gap_friction, 0);
  ASSERT_TRUE(across.gap);
  EXPECT_EQ(across.gap->breadth, 0.062);
  EXPECT_EQ(across.gap->cells, 8);
}

}  // namespace
}  // namespace slosh::tank_translation_test

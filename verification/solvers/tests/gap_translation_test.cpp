// A narrow tank as OpenFOAM receives it, in two dimensions and in three.
#include <gtest/gtest.h>

#include "verification/case/gap_friction.hpp"
#include "verification/peers/interfoam_tank.hpp"
#include "verification/tests/sample_case.hpp"

namespace slosh::gap_translation_test {
namespace {

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
}  // namespace slosh::gap_translation_test

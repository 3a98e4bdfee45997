#include "verification/runs/fitting_spacing.hpp"

#include <gtest/gtest.h>

#include "verification/input/case_file_error.hpp"
#include "verification/runs/run_case.hpp"
#include "verification/tests/sample_case.hpp"

namespace slosh::fitting_spacing_test {
namespace {

const std::string refusal = "particle_spacing = 0.03 m: expected a whole number of particles";

CaseDefinition tank_of(double length, double depth) {
  CaseDefinition definition = sample_case();
  definition.tank.length = length;
  definition.liquid.fill_depth = depth;
  return definition;
}

RunDefinition run_with(double spacing) {
  return sample_run(SphRun{
      .scheme = "recommended", .particle_spacing = spacing, .surface_particle_spacing = spacing});
}

TEST(FittingSpacing, IsTheNearestThatDividesLengthAndDepth) {
  EXPECT_NEAR(*nearest_fitting_spacing(tank_of(0.6, 0.12), 0.013), 0.6 / 45, 1e-12);
  EXPECT_NEAR(*nearest_fitting_spacing(tank_of(1, 0.35), 0.05), 0.05, 1e-12);
  EXPECT_NEAR(*nearest_fitting_spacing(tank_of(1, 0.1), 0.03), 1 / 30.0, 1e-12);
}

TEST(FittingSpacing, OfADamDividesItsColumn) {
  CaseDefinition dam = tank_of(1, 0.1);
  dam.liquid.column_width = 0.06;
  EXPECT_NEAR(*nearest_fitting_spacing(dam, 0.018), 0.02, 1e-12);
}

TEST(FittingSpacing, OfLengthsWithoutACommonDivisorIsWithinTheStretchOfALattice) {
  const CaseDefinition definition = tank_of(1, 0.317);
  const double found = *nearest_fitting_spacing(definition, 0.03);
  EXPECT_EQ(spacing_hint(refusal, definition, run_with(found)), "");
}

TEST(FittingSpacing, IsNotSoughtInATankThatIsNoRectangle) {
  CaseDefinition definition = tank_of(1, 0.1);
  definition.tank.outline = {{0, 0}, {1, 0}, {0.5, 1}};
  EXPECT_FALSE(nearest_fitting_spacing(definition, 0.03));
  EXPECT_EQ(spacing_hint(refusal, definition, run_with(0.03)), "");
}

TEST(FittingSpacing, IsToldWhereARunsSpacingDoesNotFit) {
  const CaseDefinition definition = tank_of(1, 0.1);
  EXPECT_EQ(spacing_hint(refusal, definition, run_with(0.03)),
            "; the nearest that divides both is 0.0333333 m");
  EXPECT_EQ(spacing_hint(refusal, definition, run_with(0.025)), "");
  // Another key is refused: the spacing is no part of it.
  EXPECT_EQ(spacing_hint("variant = \"none\": expected one of", definition, run_with(0.03)), "");
  try {
    require_runnable(definition, run_with(0.03));
    ADD_FAILURE() << "the run was not refused";
  } catch (const CaseFileError& error) {
    EXPECT_NE(std::string(error.what()).find("; the nearest that divides both is 0.0333333 m"),
              std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace slosh::fitting_spacing_test

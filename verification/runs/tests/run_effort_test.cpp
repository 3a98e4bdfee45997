#include "verification/runs/run_effort.hpp"

#include <gtest/gtest.h>

#include "verification/tests/sample_case.hpp"

namespace slosh::run_effort_test {
namespace {

// The tank of the sample case, 1 m x 1 m and filled to 0.35 m, with its lower corners cut off.
CaseDefinition chamfered() {
  CaseDefinition definition = sample_case();
  definition.tank.outline = {{0.2, 0}, {0.8, 0}, {1, 0.2}, {1, 1}, {0, 1}, {0, 0.2}};
  return definition;
}

TEST(RunEffort, OfSphCountsTheParticlesOfTheLiquidsSection) {
  const RunDefinition run = sample_run(SphRun{"recommended", 0.01, 0.01});
  EXPECT_NEAR(run_effort(sample_case(), run).elements, 3500, 1e-9);
  EXPECT_NEAR(run_effort(chamfered(), run).elements, 3500 - 400, 1e-9);
}

TEST(RunEffort, OfInterFoamCountsTheCellsInTheTank) {
  const RunDefinition run = sample_run(InterFoamRun{50, 40});
  EXPECT_EQ(run_effort(sample_case(), run).elements, 2000);
  EXPECT_NEAR(run_effort(chamfered(), run).elements, 0.96 * 2000, 1e-9);
}

}  // namespace
}  // namespace slosh::run_effort_test

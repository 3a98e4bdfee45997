#include "verification/assessment/doubts/surface_tension_limits.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "verification/assessment/doubts/flow_scales.hpp"
#include "verification/assessment/tests/found_limit.hpp"
#include "verification/solvers/particles/expected_speed.hpp"

namespace slosh::surface_tension_limits_test {
namespace {

using std::numbers::pi;

TEST(SurfaceTensionLimits, HaveSurfaceTensionInSmallTanks) {
  CaseDefinition definition = case_with_runs({});
  EXPECT_FALSE(found_limit(definition, "surface tension")->exceeded());
  definition.tank.length = 0.1;
  EXPECT_TRUE(found_limit(definition, "surface tension")->exceeded());
  definition.gravity = 0;
  EXPECT_FALSE(found_limit(definition, "surface tension"));
}

TEST(SurfaceTensionLimits, CompareTheCapillaryPressureAcrossTheGapWithTheWave) {
  CaseDefinition definition = case_with_runs({});
  const std::string across = "the capillary pressure between the gap walls";
  EXPECT_FALSE(found_limit(definition, across)) << "the breadth is unknown";
  definition.tank.breadth = 0.05;
  definition.motion = {};
  EXPECT_FALSE(found_limit(definition, across)) << "nothing moves";
  definition.initial_wave = InitialWaveDefinition{.mode = 1, .amplitude = -0.05};
  const auto high = found_limit(definition, across);
  ASSERT_TRUE(high);
  EXPECT_NEAR(high->value, 2 * 0.073 / 0.05 / (1000 * 9.81 * 0.05), 1e-12);
  // A wave that loses 2 % in a period.
  EXPECT_NEAR(8 / pi * high->limit, 0.02, 1e-12);
  EXPECT_FALSE(high->exceeded());
  definition.initial_wave->amplitude = 0.005;
  EXPECT_TRUE(found_limit(definition, across)->exceeded());
}

TEST(SurfaceTensionLimits, KnowTheWavesThatTheMotionOfTheTankForces) {
  CaseDefinition definition = case_with_runs({});  // at 0.3 times the first natural frequency
  const double tilt = 0.02 * std::pow(0.3 * 4.94488, 2) / 9.81;
  EXPECT_NEAR(wave_height(definition), tilt / 2 / (1 - 0.09), 1e-5);
  definition.motion.surge = SineMotion{.amplitude = 0.02, .angular_frequency = 4.94488};
  const double speed = expected_speed(definition);
  EXPECT_NEAR(wave_height(definition), speed * speed / (2 * 9.81), 1e-12) << "it breaks";
  definition.gravity = 0;
  EXPECT_EQ(wave_height(definition), 0);
}

TEST(SurfaceTensionLimits, HaveTheWeberNumberOfTheSmallestDropsInAnImpact) {
  const std::string drops = "surface tension on the smallest drops";
  EXPECT_FALSE(found_limit(case_with_runs({SphRun{"recommended", 0.004, 0.004}}), drops));
  CaseDefinition definition = violent_case({SphRun{"recommended", 0.004, 0.004}});
  const double speed = expected_speed(definition);
  const auto coarse = found_limit(definition, drops);
  ASSERT_TRUE(coarse);
  EXPECT_NEAR(1 / coarse->value, 1000 * speed * speed * 0.004 / 0.073, 1e-9);
  EXPECT_FALSE(coarse->exceeded());
  definition.runs.push_back(sample_run(InterFoamRun{.cells_x = 10000, .cells_z = 5000}));
  definition.runs.back().name = "fine_mesh";
  const auto fine = found_limit(definition, drops);
  EXPECT_NEAR(fine->value / coarse->value, 0.004 / 0.0001, 1e-9);
  EXPECT_TRUE(fine->exceeded());
  EXPECT_NE(fine->effect.find("fine_mesh has, of 0.1 mm"), std::string::npos) << fine->effect;
}

}  // namespace
}  // namespace slosh::surface_tension_limits_test

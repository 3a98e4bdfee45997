#include "verification/assessment/doubts/compression_limits.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "verification/assessment/tests/found_limit.hpp"

namespace slosh::compression_limits_test {
namespace {

CaseDefinition with_gauge_on_roof() { return violent_case({SphRun{"recommended", 0.01, 0.01}}); }

TimeSeries pressures(const std::string& name, std::vector<double> values) {
  TimeSeries series{.name = name, .unit = "Pa", .time = {}, .value = std::move(values)};
  for (std::size_t i = 0; i < series.value.size(); ++i)
    series.time.push_back(0.02 * static_cast<double>(i));
  return series;
}

const std::string air = "the compression of trapped air";

TEST(CompressionLimits, HaveTheAirOfDeclaredImpacts) {
  CaseDefinition definition = case_with_runs({});
  EXPECT_FALSE(found_limit(definition, "trapped air"));
  definition.impacts.emplace();
  definition.impacts->peak_means = {3000, 5000};
  EXPECT_NEAR(found_limit(definition, "trapped air")->value, 5000 / 101325.0, 1e-12);
  EXPECT_FALSE(found_limit(definition, "trapped air")->exceeded());
  definition.impacts->peak_means = {30000};
  EXPECT_TRUE(found_limit(definition, "trapped air")->exceeded());
}

TEST(CompressionLimits, EstimateTheImpactsOfACaseThatDeclaresNone) {
  CaseDefinition definition = with_gauge_on_roof();
  const double speed = std::sqrt(9.81 * 0.35) + 0.02 * 4.94488;
  const auto limit = found_limit(definition, air);
  ASSERT_TRUE(limit);
  EXPECT_NEAR(limit->value, 4 * 1000 * speed * speed / 101325, 1e-9);
  EXPECT_TRUE(limit->exceeded());
  EXPECT_EQ(limit->effect,
            "the compression of trapped air by impacts of an assumed 4 rho V^2, the highest of "
            "SPHERIC's benchmark 10, at the expected speed V = 2 m/s, sqrt(g h) plus the tank's "
            "largest speed");
  definition.motion.surge = SineMotion{.amplitude = 0.02, .angular_frequency = 0.3 * 4.94488};
  EXPECT_FALSE(found_limit(definition, air)) << "the waves are 2 mm high";
  definition.liquid.fill_depth = definition.tank.height - 0.001;
  EXPECT_TRUE(found_limit(definition, air)) << "they reach the roof";
  definition = with_gauge_on_roof();
  definition.pressure_gauges = {{.name = "A", .wall = Wall::left, .position = 0.1}};
  EXPECT_FALSE(found_limit(definition, air)) << "the gauge is under the still level";
}

TEST(CompressionLimits, TakeTheHighestRecordedPressureInPlaceOfTheEstimate) {
  CaseDefinition definition = with_gauge_on_roof();
  CaseRuns runs;
  runs.results["calm"].series = {pressures("wall_pressure@R", {0, 500, 0})};
  runs.results["violent"].series = {pressures("wall_pressure@R", {0, 70000, 0})};
  const auto limit = found_limit(definition, air, runs);
  ASSERT_TRUE(limit);
  EXPECT_NEAR(limit->value, 70000 / 101325.0, 1e-12);
  EXPECT_NE(limit->effect.find("the highest wall_pressure@R recorded, 70 kPa of violent"),
            std::string::npos)
      << limit->effect;
  definition.impacts.emplace();
  definition.impacts->peak_means = {5000};
  EXPECT_NEAR(found_limit(definition, air, runs)->value, 5000 / 101325.0, 1e-12)
      << "the experiment knows better";
}

TEST(CompressionLimits, ReadARecordedPressureThroughTheFilterOfItsGauge) {
  CaseDefinition definition = with_gauge_on_roof();
  definition.pressure_gauges[0].filter_cutoff = 100;
  CaseRuns runs;
  runs.results["a_run"].series = {pressures("wall_pressure@R", {0, 70000, 0}),
                                  pressures("wall_pressure@R/filtered", {0, 6000, 0})};
  EXPECT_NEAR(found_limit(definition, air, runs)->value, 6000 / 101325.0, 1e-12);
}

TEST(CompressionLimits, HaveTheCompressibilityOfRunsWithASlowSound) {
  SphRun soft{"recommended", 0.01, 0.01};
  EXPECT_FALSE(found_limit(case_with_runs({soft}), "compressibility"));
  soft.numbers.sound_speed_ratio = 10;
  EXPECT_FALSE(found_limit(case_with_runs({soft}), "compressibility")->exceeded());
  soft.numbers.sound_speed_ratio = 5;
  EXPECT_TRUE(found_limit(case_with_runs({soft}), "compressibility")->exceeded());
}

TEST(CompressionLimits, LeaveARunThatHasAResultToItsSoundness) {
  SphRun soft{"recommended", 0.01, 0.01};
  soft.numbers.sound_speed_ratio = 5;
  CaseDefinition definition = case_with_runs({soft});
  CaseRuns runs;
  runs.results[definition.runs.back().name] = {};
  EXPECT_FALSE(found_limit(definition, "compressibility", runs));
}

}  // namespace
}  // namespace slosh::compression_limits_test

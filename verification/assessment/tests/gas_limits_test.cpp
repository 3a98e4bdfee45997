#include "verification/assessment/doubts/gas_limits.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "verification/assessment/doubts/case_doubts.hpp"
#include "verification/assessment/tests/found_limit.hpp"
#include "verification/case_file/case_sections.hpp"

namespace slosh::gas_limits_test {
namespace {

using std::numbers::pi;
constexpr const char* gas = "the gas above the liquid";

CaseDefinition under_gas(double density,
                         const std::vector<decltype(RunDefinition::solver)>& solvers) {
  CaseDefinition definition = case_with_runs(solvers);
  definition.gas = air;
  definition.gas.density = density;
  return definition;
}

// An oil of 870 kg/m3 above water: the inertia of both layers and the weight of the difference.
TEST(GasLimits, TellTheFrequencyUnderAHeavyGasFromThatUnderAir) {
  const SphRun sph{"recommended", 0.01, 0.01};
  const CaseDefinition oil = under_gas(870, {sph});
  const auto heavy = found_limit(oil, gas);
  ASSERT_TRUE(heavy);
  const double k = pi / oil.tank.length, h = oil.liquid.fill_depth, height = oil.tank.height - h;
  const double inertia = 1000 / std::tanh(k * h) + 870 / std::tanh(k * height);
  EXPECT_NEAR(heavy->value, 1 - std::sqrt(130 / inertia / std::tanh(k * h)), 1e-12);
  EXPECT_TRUE(heavy->exceeded());
  bool doubted = false;
  for (const std::string& doubt : case_doubts(oil, {}))
    doubted |= doubt.find(gas) != std::string::npos;
  EXPECT_TRUE(doubted);
  EXPECT_FALSE(found_limit(under_gas(1.2, {sph}), gas)->exceeded());
}

TEST(GasLimits, NameTheRunsThatKnowTheLiquidAlone) {
  const LinearRun one_layer{.modes = 10, .valid_elevation_over_depth = 0.1},
      two_layers{.modes = 10, .two_layer = true, .valid_elevation_over_depth = 0.1};
  EXPECT_TRUE(found_limit(under_gas(870, {one_layer}), gas));
  EXPECT_TRUE(found_limit(under_gas(870, {PotentialRun{}}), gas));
  EXPECT_FALSE(
      found_limit(under_gas(870, {two_layers, InterFoamRun{.cells_x = 90, .cells_z = 51}}), gas));
}

TEST(GasLimits, TellThatSphLeavesARoofAtOnceWhereItsLiquidComesThere) {
  const SphRun sph{"recommended", 0.01, 0.01};
  constexpr const char* roof = "the gas that must follow where the liquid leaves the roof";
  CaseDefinition definition = violent_case({sph, InterFoamRun{.cells_x = 90, .cells_z = 51}});
  definition.gauges = {{"right", 0.95}};
  definition.tank.height = definition.liquid.fill_depth + 0.05;
  const auto expected = found_limit(definition, roof);
  ASSERT_TRUE(expected);
  const double front = 0.542 * std::sqrt(9.81 * definition.tank.height);
  EXPECT_NEAR(expected->value, definition.tank.length / front * 4.94488 / (2 * pi), 1e-9);
  EXPECT_NE(expected->effect.find(fmt::format("at {:.3g} m/s", front)), std::string::npos);
  EXPECT_TRUE(expected->effect.ends_with("in " + definition.runs[0].name));
  CaseRuns runs;
  RunResult& result = runs.results[definition.runs[0].name];
  result.series = {{"highest_surface@right", "m", {0, 1}, {0, 0.03}}};
  EXPECT_FALSE(found_limit(definition, roof, runs)) << "it stays below";
  result.series[0].value[1] = 0.045;
  EXPECT_TRUE(found_limit(definition, roof, runs)->exceeded());
}

TEST(GasLimits, NeedGravity) {
  CaseDefinition definition = under_gas(870, {SphRun{"recommended", 0.01, 0.01}});
  definition.gravity = 0;
  EXPECT_FALSE(found_limit(definition, gas));
}

}  // namespace
}  // namespace slosh::gas_limits_test

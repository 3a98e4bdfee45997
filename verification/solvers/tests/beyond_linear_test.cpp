// What linear theory leaves beside its series, against nonlinear potential flow and against itself
// with a thousand modes.
#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "verification/case/quantities.hpp"
#include "verification/runs/run_case.hpp"
#include "verification/series/sample_moments.hpp"
#include "verification/tests/sample_case.hpp"

namespace slosh::beyond_linear_test {
namespace {

RunResult result_of(const CaseDefinition& definition, const decltype(RunDefinition::solver)& run) {
  return execute(definition, sample_run(run), {}, [](double, double) {});
}

const LinearRun linear{.modes = 200, .valid_elevation_over_depth = 0.2};

CaseDefinition ramped_roll() {
  CaseDefinition definition = sample_case();
  definition.tank = {0.92, 0.62};
  definition.liquid.fill_depth = 0.465;
  definition.motion = {};
  definition.motion.roll = {
      SineMotion{.amplitude = 0.08, .angular_frequency = 3, .ramp_periods = 2}, 0.46, 0.31};
  definition.gauges = {{"right", 0.87}};
  definition.pressure_gauges = {{"P", Wall::left, 0.17}};
  definition.duration = 8;
  return definition;
}

CaseDefinition standing_wave() {
  CaseDefinition definition = sample_case();
  definition.motion = {};
  definition.initial_wave = InitialWaveDefinition{1, 0.03};
  definition.pressure_gauges = {{"P", Wall::left, 0.17}};
  definition.duration = 8;
  return definition;
}

struct LeftOut {
  double error;  // of the estimate, as a share of what linear theory leaves out
  double size;   // of the estimate, likewise
};

LeftOut left_out(const CaseDefinition& definition, const std::string& quantity) {
  const RunResult theory = result_of(definition, linear),
                  flow = result_of(definition, PotentialRun{32, 16});
  const std::vector<double>&exact = flow.at(quantity).value, &own = theory.at(quantity).value,
        &moved = theory.at(quantity + nonlinear).value;
  const double truth = rms(minus(exact, own));
  return {rms(minus(moved, exact)) / truth, rms(minus(moved, own)) / truth};
}

TEST(BeyondLinear, IsWhatPotentialFlowAddsToAStandingWaveAndOfTheSizeOfThatElsewhere) {
  EXPECT_LT(left_out(standing_wave(), "elevation@right").error, 0.05);
  const std::vector<std::pair<CaseDefinition, const char*>> others{
      {ramped_roll(), "elevation@right"},
      {standing_wave(), "wall_pressure@P"},
      {ramped_roll(), "wall_pressure@P"},
      {standing_wave(), "force_x"},
      {ramped_roll(), "force_x"}};
  for (const auto& [definition, quantity] : others) {
    const double size = left_out(definition, quantity).size;
    EXPECT_GT(size, 0.7) << quantity;
    // Measured: 2 to 4; of the force 3 and 16, as short waves count for it as long ones do.
    EXPECT_LT(size, quantity == std::string("force_x") ? 20 : 6) << quantity;
  }
}

TEST(BeyondLinear, TheModesThatATheoryLacksAreToldByThoseThatItAdds) {
  CaseDefinition definition = sample_case();
  definition.gauges.push_back({"node", 0.5 + 1.0 / 3});  // of the third half wave
  // Where the modes 7 to 12 of a surge cancel one another.
  definition.gauges.push_back({"cancelled", 0.97});
  const RunResult exact = result_of(definition, LinearRun{1000, false, 0.2});
  for (const int modes : {1, 2, 5, 6, 20, 100}) {
    const RunResult theory = result_of(definition, LinearRun{modes, false, 0.2});
    for (const char* quantity : {"elevation@right", "elevation@node", "elevation@cancelled"}) {
      const auto& own = theory.at(quantity).value;
      const double lacks = rms(minus(own, exact.at(quantity).value));
      const double told = 1.25 * rms(minus(own, theory.at(quantity + std::string(finer)).value));
      EXPECT_GT(told, lacks) << modes << " " << quantity;
      EXPECT_LT(told, 4 * lacks) << modes << " " << quantity;
    }
  }
}

// 50,000 samples of a thousand modes and of those beyond them took 14 s.
TEST(BeyondLinear, TheModesThatATheoryLacksTakeFewOfManySamples) {
  CaseDefinition definition = sample_case();
  const RunResult usual = result_of(definition, LinearRun{20, false, 0.2});
  definition.sample_interval /= 400;
  const RunResult many = result_of(definition, LinearRun{20, false, 0.2});
  const auto told = [](const RunResult& of) {
    return rms(
        minus(of.at("elevation@right").value, of.at("elevation@right" + std::string(finer)).value));
  };
  EXPECT_GT(many.at("elevation@right").value.size(), 20000U);
  EXPECT_NEAR(told(many), told(usual), 0.05 * told(usual));
}

TEST(BeyondLinear, IsNotToldOfWavesThatAreTooSteepForIt) {
  CaseDefinition definition = standing_wave();
  definition.initial_wave->amplitude = 0.3;
  const RunResult theory = result_of(definition, linear);
  for (const TimeSeries& one : theory.series) EXPECT_FALSE(one.name.ends_with(nonlinear));
}

}  // namespace
}  // namespace slosh::beyond_linear_test

// What linear theory leaves beside its series, against nonlinear potential flow and against itself
// with a thousand modes.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <tuple>
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

// Tanks of 1 m with sensors at the walls, under crests, nodes and near the surface.
CaseDefinition tank_of_depth(double depth) {
  CaseDefinition definition = sample_case();
  definition.tank = {1.0, 1.5};
  definition.liquid.fill_depth = depth;
  definition.motion = {};
  definition.start = Start::tank;
  definition.gauges = {{"right", 1.0}, {"middle", 0.6}};
  definition.pressure_gauges = {{"low", Wall::left, 0.2 * depth},
                                {"high", Wall::left, 0.8 * depth},
                                {"near", Wall::right, 0.97 * depth},
                                {"bottom", Wall::bottom, 0.5}};
  for (const auto& [name, x] : {std::pair{"wall", 0.02}, {"quarter", 0.25}, {"beside", 0.37}})
    for (const double height : {0.3, 0.8})
      definition.probes.push_back({fmt::format("{}_{:.0f}", name, 10 * height), x, height * depth});
  definition.duration = 8;
  return definition;
}

// The estimate over what nonlinear potential flow adds to linear theory, rms, of each series where
// that is more than a thousandth of the series: a smaller one is that of the flow's own grid.
struct Told {
  std::string name;
  double share;
};

std::vector<Told> told_of(const CaseDefinition& definition) {
  const RunResult theory = result_of(definition, linear),
                  flow = result_of(definition, PotentialRun{24, 12});
  std::vector<Told> found;
  for (const TimeSeries& one : theory.series) {
    if (one.name.find('/') != std::string::npos) continue;
    const std::vector<double>& exact = flow.at(one.name).value;
    EXPECT_EQ(exact.size(), one.value.size()) << one.name;
    const double truth = rms(minus(exact, one.value));
    if (truth < 1e-3 * rms(without_mean(exact))) continue;
    found.push_back(
        {one.name, rms(minus(theory.at(one.name + nonlinear).value, one.value)) / truth});
  }
  return found;
}

void expect_within(const CaseDefinition& definition, double least, double most,
                   const std::string& what) {
  const std::vector<Told> all = told_of(definition);
  EXPECT_GT(all.size(), 10U) << what;
  for (const auto& [name, share] : all) {
    EXPECT_GT(share, least) << what << " " << name;
    EXPECT_LT(share, most) << what << " " << name;
  }
}

TEST(BeyondLinear, IsWhatPotentialFlowAddsToEachQuantityOfAStandingWave) {
  for (const auto& [depth, steepness] :
       {std::pair{0.2, 0.1}, {0.3, 0.05}, {0.3, 0.15}, {0.6, 0.2}, {1.0, 0.1}, {1.0, 0.2}}) {
    CaseDefinition definition = tank_of_depth(depth);
    definition.initial_wave = InitialWaveDefinition{1, steepness / std::numbers::pi};
    expect_within(definition, 0.8, 1.25, fmt::format("{} {}", depth, steepness));
  }
}

TEST(BeyondLinear, IsWhatPotentialFlowAddsToEachQuantityOfASurge) {
  for (const auto& [depth, amplitude, frequency] :
       {std::tuple{0.2, 0.004, 4.5}, {0.3, 0.01, 3.0}, {0.6, 0.004, 4.5}, {0.6, 0.01, 3.0}}) {
    CaseDefinition definition = tank_of_depth(depth);
    definition.motion.surge =
        SineMotion{.amplitude = amplitude, .angular_frequency = frequency, .ramp_periods = 2};
    expect_within(definition, 0.8, 1.25, fmt::format("{} {} {}", depth, amplitude, frequency));
  }
}

TEST(BeyondLinear, IsWhatPotentialFlowAddsToEachQuantityOfARoll) {
  for (const auto& [depth, angle, frequency, axis] : {std::tuple{0.2, 0.03, 2.0, 0.3},
                                                      {0.2, 0.08, 2.0, 0.3},
                                                      {0.2, 0.01, 3.5, 0.3},
                                                      {0.5, 0.03, 3.5, 0.0},
                                                      {0.5, 0.08, 2.0, 0.0},
                                                      {1.0, 0.03, 3.5, 0.3}}) {
    CaseDefinition definition = tank_of_depth(depth);
    definition.motion.roll = {
        SineMotion{.amplitude = angle, .angular_frequency = frequency, .ramp_periods = 2}, 0.5,
        axis};
    expect_within(definition, 0.7, 2.5, fmt::format("{} {} {}", depth, angle, frequency));
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
  CaseDefinition definition = tank_of_depth(0.35);
  definition.initial_wave = InitialWaveDefinition{1, 0.3};
  const RunResult theory = result_of(definition, linear);
  for (const TimeSeries& one : theory.series) EXPECT_FALSE(one.name.ends_with(nonlinear));
}

}  // namespace
}  // namespace slosh::beyond_linear_test

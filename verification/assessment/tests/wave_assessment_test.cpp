// A free wave judged by its decay and its frequency, and that the gate turns red on every way in
// which they can be wrong.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "reference/viscous_standing_wave.hpp"
#include "verification/assessment/case_assessment.hpp"
#include "verification/tests/surge_results.hpp"

namespace slosh::wave_assessment_test {
namespace {

constexpr double viscosity = 0.004;  // [m2/s], at k = pi a damping of 0.0706 1/s in unit gravity

// 20 s of the wave at the left wall, in a tank of 1 m filled to 1 m under a gravity of 1 m/s2.
TimeSeries wave_of(double nu, int mode = 1) {
  const reference::ViscousStandingWave wave({1, 1, 1, 1000}, nu, {mode, 0.02});
  TimeSeries series{surge_quantity, "m", {}, {}};
  for (int i = 0; i <= 500; ++i) series.time.push_back(0.04 * i);
  series.value = wave.elevation(-0.5, series.time);
  return series;
}

TimeSeries inviscid_wave() {
  const reference::StandingWave wave({1, 1, 1, 1000}, std::nullopt, {1, 0.02});
  TimeSeries series = wave_of(viscosity);
  for (std::size_t i = 0; i < series.time.size(); ++i)
    series.value[i] = wave.elevation(-0.5, series.time[i]);
  return series;
}

CaseDefinition wave_case() {
  CaseDefinition definition = surge_case();
  definition.gravity = 1;
  definition.tank = {1, 1.5};
  definition.liquid = {1, 1000, viscosity};
  definition.motion = {};
  definition.initial_wave = InitialWaveDefinition{1, 0.02};
  definition.start = Start::tank;
  definition.runs[0].solver = ViscousWaveRun{0.1};  // "theory"
  definition.gate = {surge_row("natural_1", Metric::decay_error, "1", 0.05),
                     surge_row("natural_1", Metric::frequency_error, "1", 0.005)};
  return definition;
}

CaseAssessment assess_wave(const TimeSeries& candidate,
                           const TimeSeries& theory = wave_of(viscosity)) {
  CaseRuns runs;
  for (const auto& [run, series] : {std::pair{"theory", theory},
                                    {"theory_with_gas", inviscid_wave()},
                                    {"particles", candidate},
                                    {"coarse_mesh", theory},
                                    {"fine_mesh", theory}}) {
    runs.results[run] = result_of(run, series);
    runs.status[run] = {RunState::finished, ""};
  }
  return assess(wave_case(), std::move(runs));
}

TEST(WaveAssessment, PassesACandidateThatIsItsReferenceAndComparesItWithTheTheoriesOfItsKind) {
  const CaseAssessment assessment = assess_wave(wave_of(viscosity));
  for (const GateOutcome& outcome : assessment.gate) {
    EXPECT_EQ(outcome.verdict, Verdict::pass) << outcome.message;
    EXPECT_NEAR(outcome.value.value, 0, 1e-12);
  }
  std::vector<std::string> pairs;
  for (const Comparison& one : assessment.comparisons)
    pairs.push_back(one.candidate + " against " + one.reference);
  EXPECT_EQ(pairs, (std::vector<std::string>{
                       "particles against theory", "particles against fine_mesh",
                       "coarse_mesh against theory", "coarse_mesh against theory_with_gas",
                       "fine_mesh against theory", "fine_mesh against theory_with_gas"}));
  CaseDefinition low = wave_case();
  low.runs[0].solver = ViscousWaveRun{0.01};  // of an elevation of 0.027 depths
  const CaseAssessment too_high = assess(low, assessment.runs);
  EXPECT_EQ(too_high.runs.status.at("theory").state, RunState::out_of_range);
  EXPECT_EQ(too_high.gate[0].verdict, Verdict::not_compared);
}

TEST(WaveAssessment, RejectsACandidateThatDecaysATenthTooFast) {
  TimeSeries fast = wave_of(viscosity);
  for (std::size_t i = 0; i < fast.time.size(); ++i)
    fast.value[i] *= std::exp(-0.1 * 0.0706 * fast.time[i]);
  const CaseAssessment assessment = assess_wave(fast);
  EXPECT_EQ(assessment.gate[0].verdict, Verdict::violated);
  EXPECT_NEAR(assessment.gate[0].value.value, 0.1, 2e-3);
  EXPECT_GT(assessment.gate[0].value.half_width, 0);
  EXPECT_LT(assessment.gate[0].value.half_width, 0.01);
  EXPECT_EQ(assessment.gate[1].verdict, Verdict::pass);
  EXPECT_EQ(exit_status({assessment}), exit_violated);
}

TEST(WaveAssessment, RejectsAnInviscidCandidateAndTheViscosityOfAnotherReynoldsNumber) {
  const CaseAssessment inviscid = assess_wave(inviscid_wave()), thick = assess_wave(wave_of(0.02));
  for (const CaseAssessment& one : {inviscid, thick})
    EXPECT_EQ(one.gate[0].verdict, Verdict::violated);
  EXPECT_EQ(thick.gate[1].verdict, Verdict::violated);
  // What the fits leave of the viscous wave corrects its decay by 3e-4.
  EXPECT_NEAR(inviscid.gate[0].value.value, -1, 1e-3);
  // The fit takes the growing vorticity layer in: one per cent of the decay at Re = 50.
  EXPECT_NEAR(thick.gate[0].value.value, 0.29665 / 0.07055 - 1, 0.05);
}

TEST(WaveAssessment, ComparesNothingWithNumbersThatAreNoneOrADecayThatThereIsNot) {
  TimeSeries broken = wave_of(viscosity);
  broken.value[250] = std::numeric_limits<double>::quiet_NaN();
  for (const CaseAssessment& one : {assess_wave(broken), assess_wave(wave_of(viscosity), broken)})
    for (const GateOutcome& outcome : one.gate) EXPECT_EQ(outcome.verdict, Verdict::not_compared);
  const GateOutcome outcome = assess_wave(wave_of(viscosity), inviscid_wave()).gate[0];
  EXPECT_EQ(outcome.verdict, Verdict::not_compared);
  EXPECT_EQ(outcome.message,
            "the reference's mode natural_1 does not decay; expected a viscous one, or the metric "
            "decay_rate");
}

TEST(WaveAssessment, LooksForTheWavesOwnMode) {
  CaseDefinition definition = wave_case();
  definition.initial_wave->mode = 2;
  const auto modes = fitted_modes(definition);
  ASSERT_EQ(modes.size(), 1u);
  EXPECT_EQ(modes[0].name, "natural_2");
  EXPECT_NEAR(modes[0].angular_frequency, std::sqrt(2 * M_PI * std::tanh(2 * M_PI)), 1e-12);
}

}  // namespace
}  // namespace slosh::wave_assessment_test

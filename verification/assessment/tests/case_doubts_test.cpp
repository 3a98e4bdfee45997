#include "verification/assessment/doubts/case_doubts.hpp"

#include <gtest/gtest.h>

#include "verification/tests/sample_case.hpp"

namespace slosh::case_doubts_test {
namespace {

CaseDefinition sound_case() {
  CaseDefinition definition = sample_case();
  definition.duration = 20;
  definition.window_begin = 1;
  definition.window_end = 20;
  definition.runs = {sample_run(LinearRun{.modes = 10, .valid_elevation_over_depth = 0.1}),
                     sample_run(SphRun{"recommended", 0.025, 0.025})};
  definition.runs[0].name = "linear";
  definition.runs[1].name = "particles";
  definition.gate = {{.candidate = "particles",
                      .reference = "linear",
                      .quantity = "elevation@right",
                      .mode = "forced",
                      .metric = Metric::amplitude_error,
                      .unit = "1",
                      .limit = 0.1,
                      .between = {},
                      .improves_on = {},
                      .reason = "",
                      .source = "",
                      .where = {"small_surge.toml", 7}}};
  return definition;
}

CaseRuns theory(double over_depth) {
  CaseRuns runs;
  runs.results["linear"].diagnostics["highest_elevation_over_depth"] = over_depth;
  return runs;
}

RecordRun record_from(const std::vector<double>& time, bool supplied = true) {
  RecordRun record{.file = {},
                   .quantity = "elevation@right",
                   .unit = "m",
                   .time = time,
                   .value = {},
                   .uncertainty = {},
                   .supplied = supplied};
  for (std::size_t i = 0; i < time.size(); ++i) record.value.push_back(i % 2 ? 1 : 0);
  return record;
}

// The only doubt about the case begins with this text.
::testing::AssertionResult doubts(const CaseDefinition& definition, const std::string& text,
                                  const CaseRuns& runs = theory(0.03)) {
  const std::vector<std::string> found = case_doubts(definition, runs);
  if (found.size() == 1 && found[0].starts_with(text)) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << ::testing::PrintToString(found);
}

// Each makes a sound case doubtful in one way.
TEST(CaseDoubts, TellWhatIsWrongOfACaseAndNothingOfASoundOne) {
  EXPECT_EQ(case_doubts(sound_case(), theory(0.03)), std::vector<std::string>{});
  const struct {
    void (*spoil)(CaseDefinition&);
    const char* says;
    double over_depth = 0.03;
  } wrong[] = {
      {[](CaseDefinition& one) { std::get<SphRun>(one.runs[1].solver).particle_spacing = 0.02; },
       "run particles: particle_spacing_m = 0.02 does not divide the liquid's length and depth: "
       "the start stretches its cells by 2.8 %; the nearest that does is 0.0166667"},
      {[](CaseDefinition& one) { one.window_end = 10; },
       "comparison: its window of 9 s is 2.1 periods of the motion"},
      {[](CaseDefinition& one) { one.sample_interval = 0.2; },
       "time: sample_interval_s = 0.2 leaves 6.3 samples in a period of natural_1"},
      {[](CaseDefinition&) {},
       "run linear: outside its range, it judges nothing (1 gate rows need it): it predicts an "
       "elevation of 0.11 fill depths, valid to 0.1",
       0.11},
      {[](CaseDefinition& one) { one.gate.clear(); }, "gate: there is no row"},
      {[](CaseDefinition& one) {
         one.runs[0].solver = InterFoamRun{20, 20};
       },
       "run: there is neither a theory nor a record"},
      {[](CaseDefinition& one) { one.runs[0].solver = record_from({}, false); },
       "run linear: the record is not supplied: 1 gate rows"},
      {[](CaseDefinition& one) {
         one.runs[0].solver = record_from({3, 3.5, 4, 4.5});
       },
       "run linear: the record begins at 3 s, after the comparison's window, which begins at 1 s: "
       "rows on it judge what follows alone"},
      {[](CaseDefinition& one) {
         one.runs[0].solver = record_from({30, 30.5, 31, 31.5});
       },
       "run linear: the record begins at 30 s, after the comparison's window, which begins at 1 s: "
       "no row on it can be judged"},
      {[](CaseDefinition& one) {
         one.pressure_gauges = {{"high", Wall::left, 0.4}};
         one.gate[0].quantity = "wall_pressure@high";
       },
       "gate row of line 7: linear has no pressure at the gauge high"}};
  for (const auto& [spoil, says, over_depth] : wrong) {
    CaseDefinition definition = sound_case();
    spoil(definition);
    const bool is_theory = std::holds_alternative<LinearRun>(definition.runs[0].solver);
    EXPECT_TRUE(doubts(definition, says, is_theory ? theory(over_depth) : CaseRuns{}));
  }
  CaseDefinition within_a_sample = sound_case(), high_gauge = sound_case();
  within_a_sample.runs[0].solver = record_from({1.4, 1.9, 2.4, 2.9});
  EXPECT_EQ(case_doubts(within_a_sample, {}), std::vector<std::string>{});
  high_gauge.pressure_gauges = {{"high", Wall::left, 0.4}};
  EXPECT_EQ(case_doubts(high_gauge, theory(0.03)), std::vector<std::string>{}) << "no row needs it";
}

TEST(CaseDoubts, AreNotOfTheSpacingInATankThatIsNoRectangle) {
  CaseDefinition definition = sound_case();
  std::get<SphRun>(definition.runs[1].solver).particle_spacing = 0.02;
  definition.tank.outline = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  definition.natural_modes = 0;
  EXPECT_EQ(case_doubts(definition, {}), std::vector<std::string>{});
}

TEST(CaseDoubts, AreOfAGaugeWithinSixSpacingsOfAnObstacle) {
  CaseDefinition definition = sound_case();
  definition.obstacles = {{"baffle", 0.5, 0.52, 0, 0.1}};
  EXPECT_EQ(case_doubts(definition, theory(0.03)).size(), 0u);
  definition.gauges.push_back({"near", 0.6});
  EXPECT_TRUE(doubts(definition, "gauge near: x_m = 0.6 is 0.08 m from the obstacle baffle"));
  definition.obstacles[0].bottom = 0.5;
  definition.obstacles[0].top = 0.6;
  EXPECT_EQ(case_doubts(definition, theory(0.03)).size(), 0u) << "it is above the liquid";
}

TEST(CaseDoubts, TellOfAScriptWhoseModulesAreNoPartOfItsKey) {
  CaseDefinition definition = sound_case();
  definition.file = "small_surge.toml";
  ExternalRun external;
  external.command = {"python3", "-m", "mine"};
  definition.runs.push_back(sample_run(external));
  definition.runs.back().name = "mine";
  EXPECT_TRUE(doubts(definition, "run mine: what python3 loads or holds is no part of its key"));
  std::get<ExternalRun>(definition.runs.back().solver).inputs = {"mine"};
  EXPECT_EQ(case_doubts(definition, theory(0.03)), std::vector<std::string>{});
}

}  // namespace
}  // namespace slosh::case_doubts_test

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

// The only doubt about the case begins with this text.
::testing::AssertionResult doubts(const CaseDefinition& definition, const std::string& text,
                                  const CaseRuns& runs = theory(0.03)) {
  const std::vector<std::string> found = case_doubts(definition, runs);
  if (found.size() == 1 && found[0].starts_with(text)) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << ::testing::PrintToString(found);
}

TEST(CaseDoubts, AreNoneAboutASoundCase) {
  EXPECT_EQ(case_doubts(sound_case(), theory(0.03)), std::vector<std::string>{});
}

TEST(CaseDoubts, NameTheNearestSpacingThatDividesTheTank) {
  CaseDefinition definition = sound_case();
  std::get<SphRun>(definition.runs[1].solver).particle_spacing = 0.02;
  EXPECT_TRUE(doubts(definition,
                     "run particles: particle_spacing_m = 0.02 does not divide the liquid's length "
                     "and depth: the start stretches its cells by 2.8 %; the nearest that does is "
                     "0.0166667"));
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

TEST(CaseDoubts, AreOfAWindowOfLessThanThreePeriods) {
  CaseDefinition definition = sound_case();
  definition.window_end = 10;
  EXPECT_TRUE(doubts(definition, "comparison: its window of 9 s is 2.1 periods of the motion"));
}

TEST(CaseDoubts, AreOfSamplesThatMissTheCrests) {
  CaseDefinition definition = sound_case();
  definition.sample_interval = 0.2;
  EXPECT_TRUE(doubts(definition,
                     "time: sample_interval_s = 0.2 leaves 6.3 samples in a period of "
                     "natural_1"));
}

TEST(CaseDoubts, AreOfATheoryOutsideItsRange) {
  EXPECT_TRUE(doubts(sound_case(),
                     "run linear: outside its range, it judges nothing (1 gate rows need it): it "
                     "predicts an elevation of 0.11 fill depths, valid to 0.1",
                     theory(0.11)));
}

TEST(CaseDoubts, AreOfACaseThatCannotFailOrHasNoTruth) {
  CaseDefinition definition = sound_case();
  definition.gate.clear();
  EXPECT_TRUE(doubts(definition, "gate: there is no row"));
  definition = sound_case();
  definition.runs[0].solver = InterFoamRun{20, 20};
  EXPECT_TRUE(doubts(definition, "run: there is neither a theory nor a record", {}));
}

TEST(CaseDoubts, AreOfARecordThatIsNotSupplied) {
  CaseDefinition definition = sound_case();
  definition.runs[0].solver = RecordRun{.file = {},
                                        .quantity = "elevation@right",
                                        .unit = "m",
                                        .time = {},
                                        .value = {},
                                        .uncertainty = {},
                                        .supplied = false};
  EXPECT_TRUE(doubts(definition, "run linear: the record is not supplied: 1 gate rows", {}));
}

TEST(CaseDoubts, AreOfARecordThatBeginsAfterTheWindow) {
  CaseDefinition definition = sound_case();
  RecordRun record{.file = {},
                   .quantity = "elevation@right",
                   .unit = "m",
                   .time = {},
                   .value = {},
                   .uncertainty = {}};
  const auto with_record_from = [&](double begin) {
    record.time = {begin, begin + 0.5, begin + 1, begin + 1.5};
    record.value = {0, 1, 0, 1};
    definition.runs[0].solver = record;
    return definition;
  };
  EXPECT_EQ(case_doubts(with_record_from(1.4), {}).size(), 0u) << "within a sample";
  EXPECT_TRUE(doubts(with_record_from(3),
                     "run linear: the record begins at 3 s, after the comparison's window, which "
                     "begins at 1 s: rows on it judge what follows alone",
                     {}));
  EXPECT_TRUE(doubts(with_record_from(30),
                     "run linear: the record begins at 30 s, after the comparison's window, which "
                     "begins at 1 s: no row on it can be judged",
                     {}));
}

TEST(CaseDoubts, AreOfAPressureThatTheoryDoesNotHave) {
  CaseDefinition definition = sound_case();
  definition.pressure_gauges = {{"high", Wall::left, 0.4}};
  EXPECT_EQ(case_doubts(definition, theory(0.03)).size(), 0u);
  definition.gate[0].quantity = "wall_pressure@high";
  EXPECT_TRUE(doubts(definition, "gate row of line 7: linear has no pressure at the gauge high"));
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

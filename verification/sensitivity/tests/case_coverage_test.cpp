// What the rows of a case detect together, and what the self-test keeps of it.
#include "verification/sensitivity/case_coverage.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "verification/tests/surge_results.hpp"
#include "verification/tests/temporary_directory.hpp"

namespace slosh::case_coverage_test {
namespace {

const std::vector<GateRow> complete{surge_row("forced", Metric::amplitude_error, "1", 0.05),
                                    surge_row("forced", Metric::phase_lag, "deg", 5),
                                    surge_row("whole", Metric::mean_offset, "m", 0.0035),
                                    surge_row("whole", Metric::noise_share, "1", 0.05)};

CaseAssessment surge_with(const std::vector<GateRow>& gate) {
  CaseDefinition definition = surge_case();
  definition.gate = gate;
  return assess(definition, surge_runs());
}

CaseCoverage coverage_with(const std::vector<GateRow>& gate) {
  const CaseAssessment assessment = surge_with(gate);
  return case_coverage(assessment, gate_sensitivity(assessment));
}

Coverage of(const CaseCoverage& coverage, Spoiling spoiling) {
  return coverage.detections.at(spoiling).coverage;
}

TEST(CaseCoverage, OfRowsThatTogetherDetectAllIsComplete) {
  const CaseCoverage coverage = coverage_with(complete);
  for (const RequiredDetection& one : required_detections)
    EXPECT_EQ(of(coverage, one.spoiling), Coverage::detected) << spoiling_name(one.spoiling);
  EXPECT_TRUE(coverage.missed().empty());
  EXPECT_EQ(coverage.rows_judged, 4);
  EXPECT_EQ(
      coverage.detections.at(Spoiling::datum).rows,
      std::vector<std::string>{"particles against theory, whole mean_offset of elevation@right"});
}

TEST(CaseCoverage, OfAPhaseAloneMissesTheAmplitudeTheDatumAndNoise) {
  const CaseCoverage coverage = coverage_with({complete[1]});
  EXPECT_EQ(coverage.missed(), (std::vector<std::string>{"amplitude", "datum", "noise"}));
}

TEST(HashOfRows, IsThatOfTheRowsInWhateverOrder) {
  CaseDefinition definition = surge_case();
  definition.gate = complete;
  const std::string hash = hash_of_rows(definition);
  std::reverse(definition.gate.begin(), definition.gate.end());
  EXPECT_EQ(hash_of_rows(definition), hash);
  definition.gate[0].limit = 0.06;
  EXPECT_NE(hash_of_rows(definition), hash) << "a limit has changed";
  definition.gate = complete;
  definition.gate.pop_back();
  EXPECT_NE(hash_of_rows(definition), hash) << "a row is gone";
}

TEST(CaseCoverage, WithoutRowsMissesEverything) {
  const CaseCoverage coverage = coverage_with({});
  EXPECT_EQ(coverage.missed(), names_of_required());
}

TEST(CaseCoverage, OfLiquidThatNothingMovesHasNoLag) {
  CaseAssessment assessment = surge_with({});
  assessment.definition.motion = {};
  const CaseCoverage coverage = case_coverage(assessment, {});
  for (const Spoiling moved : {Spoiling::amplitude, Spoiling::lag, Spoiling::noise})
    EXPECT_EQ(of(coverage, moved), Coverage::not_applicable) << spoiling_name(moved);
  EXPECT_EQ(coverage.missed(), (std::vector<std::string>{"datum", "truncation"}));
}

TEST(CaseCoverage, CountsNoRowThatDoesNotPassAsItIs) {
  TimeSeries high = elevation_of({});
  for (double& value : high.value) value *= 1.2;
  CaseDefinition definition = surge_case();
  definition.gate = {complete[0]};
  const CaseAssessment assessment = assess(definition, surge_runs_with("particles", high));
  const CaseCoverage coverage = case_coverage(assessment, gate_sensitivity(assessment));
  EXPECT_EQ(of(coverage, Spoiling::amplitude), Coverage::missed);
  EXPECT_EQ(coverage.rows_judged, 1);
}

TEST(CoverageSentence, NamesTheCasesThatNoRowJudges) {
  EXPECT_EQ(coverage_sentence({surge_with(complete)}), "");
  EXPECT_EQ(coverage_sentence({surge_with(complete), surge_with({})}),
            " 4 of 4 rows declared are judged; no row judges small_surge.");
  CaseDefinition definition = surge_case();
  const CaseAssessment left_out =
      assess(definition, surge_runs_without("particles", RunState::not_selected, "left out"));
  EXPECT_EQ(coverage_sentence({left_out}),
            " 0 of 3 rows declared are judged; no row judges small_surge.");
}

TEST(SelftestRecord, OutlivesItsFile) {
  const TemporaryDirectory temporary;
  const auto file = selftest_record_file(temporary.path(), "surges", true);
  EXPECT_EQ(file.filename(), "surges-quick.selftest.json");
  write_selftest_record({"surges", true, {coverage_with(complete)}}, file);
  const SelftestRecord read = read_selftest_record(file);
  EXPECT_EQ(read.campaign, "surges");
  EXPECT_TRUE(read.quick);
  ASSERT_EQ(read.cases.size(), 1U);
  EXPECT_EQ(read.cases[0].rows_judged, 4);
  EXPECT_EQ(read.cases[0].detections.at(Spoiling::noise).rows.size(), 2U);
  EXPECT_TRUE(shortcomings(read, {surge_with(complete).definition}).empty());
}

TEST(SelftestRecord, IsOneOfTheRowsThatItWasMadeOf) {
  const SelftestRecord record{"surges", false, {coverage_with(complete)}};
  std::vector<GateRow> loosened = complete;
  loosened[0].limit = 0.06;
  EXPECT_EQ(
      shortcomings(record, {surge_with(loosened).definition}),
      std::vector<std::string>{"small_surge: its rows have changed since the record was made"});
  CaseDefinition other = surge_with(complete).definition;
  other.name = "other";
  EXPECT_EQ(shortcomings(record, {other}), std::vector<std::string>{"other: is not in the record"});
}

TEST(SelftestRecord, TellsWhatIsMissed) {
  const SelftestRecord record{"surges", false, {coverage_with({complete[1]})}};
  EXPECT_EQ(shortcomings(record, {surge_with({complete[1]}).definition}),
            (std::vector<std::string>{"small_surge: no row detects the amplitude",
                                      "small_surge: no row detects the datum",
                                      "small_surge: no row detects the noise"}));
}

TEST(SelftestRecord, ThatIsNotThereOrNoneIsAnError) {
  const TemporaryDirectory temporary;
  EXPECT_THROW(read_selftest_record(temporary.path() / "a.json"), SelftestRecordError);
  const auto file = temporary.path() / "b.json";
  write_selftest_record({"surges", false, {}}, file);
  EXPECT_TRUE(read_selftest_record(file).cases.empty());
}

}  // namespace
}  // namespace slosh::case_coverage_test

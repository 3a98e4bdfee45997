#include "verification/baseline/gate_history.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "verification/files/content_hash.hpp"
#include "verification/files/result_error.hpp"
#include "verification/series/time_series.hpp"

namespace slosh::gate_history_test {
namespace {

namespace fs = std::filesystem;

class GateHistory : public testing::Test {
 protected:
  GateHistory() { fs::remove_all(file_.parent_path()); }
  ~GateHistory() override { fs::remove_all(file_.parent_path()); }

  const fs::path file_ = fs::path(testing::TempDir()) / "gate_history/history/surges.jsonl";
};

CampaignState state(const std::string& when, double value) {
  return {when,
          {{"surge: sph rms", {{value, 0.1, -1.0, 1.0}, true}},
           {"surge: sph order", {{2.0, 0, {}, {}}, false}}},
          {{"surge/sph", "question-answer"}}};
}

TEST_F(GateHistory, ReadsWhatWasAppended) {
  append_state(state("2026-01-02T00:00:00Z", 0.3), file_);
  append_state(state("2026-01-03T00:00:00Z", 0.4), file_);
  const auto states = read_history(file_);
  ASSERT_EQ(states.size(), 2u);
  EXPECT_EQ(states[1].when_utc, "2026-01-03T00:00:00Z");
  EXPECT_EQ(states[1].rows, state("", 0.4).rows);
  EXPECT_EQ(states[1].results, state("", 0.4).results);
}

TEST_F(GateHistory, IsNotContinuedByAStateThatIsTheLastOnes) {
  append_state(state("2026-01-02T00:00:00Z", 0.3), file_);
  append_state(state("2026-01-03T00:00:00Z", 0.3), file_);
  EXPECT_EQ(read_history(file_).size(), 1u);
  CampaignState other_result = state("2026-01-04T00:00:00Z", 0.3);
  other_result.results["surge/sph"] = "question-other";
  append_state(other_result, file_);
  EXPECT_EQ(read_history(file_).size(), 2u);
}

TEST_F(GateHistory, IsEmptyWithoutAFile) { EXPECT_TRUE(read_history(file_).empty()); }

TEST_F(GateHistory, RefusesATruncatedLineByItsNumberAndKeepsTheFile) {
  append_state(state("2026-01-02T00:00:00Z", 0.3), file_);
  std::ofstream(file_, std::ios::app) << R"({"when_utc": "2026-)";
  const std::string before = read_bytes(file_);
  try {
    append_state(state("2026-01-03T00:00:00Z", 0.4), file_);
    FAIL() << "a truncated history was continued";
  } catch (const ResultError& error) {
    EXPECT_NE(std::string(error.what()).find("surges.jsonl:2: not a line of"), std::string::npos)
        << error.what();
  }
  EXPECT_EQ(read_bytes(file_), before);
}

GateOutcome outcome(double value, Verdict verdict, const std::string& mode) {
  GateOutcome result{};
  result.row.candidate = "sph";
  result.row.quantity = "elevation@right";
  result.row.mode = mode;
  result.row.unit = "1";
  result.row.limit = 0.05;
  result.verdict = verdict;
  result.value = {value, 0.005};
  return result;
}

TEST(CampaignStates, HoldJudgedRowsWithFiniteValuesAndAllResults) {
  CaseAssessment surge{};
  surge.definition.name = "surge";
  surge.gate = {outcome(0.02, Verdict::pass, "forced"), outcome(0.2, Verdict::violated, "whole"),
                outcome(not_a_number, Verdict::violated, "natural_1"),
                outcome(0.02, Verdict::not_selected, "natural_2")};
  surge.runs.results["sph"].key = "question-answer";
  const CampaignState state = state_of({surge}, "2026-01-02T00:00:00Z");
  ASSERT_EQ(state.rows.size(), 2u);
  for (const auto& [row, judged] : state.rows) {
    EXPECT_TRUE(row.starts_with("surge: sph")) << row;
    EXPECT_EQ(judged.holds, judged.value.value == 0.02);
    EXPECT_EQ(judged.value.upper, 0.05);
  }
  EXPECT_EQ(state.results, (std::map<std::string, std::string>{{"surge/sph", "question-answer"}}));
}

}  // namespace
}  // namespace slosh::gate_history_test

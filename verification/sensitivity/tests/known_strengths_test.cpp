// What reports keep of what their gate rows detect, and when they find it out again.
#include "verification/sensitivity/known_strengths.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "verification/sensitivity/row_strength.hpp"
#include "verification/tests/surge_results.hpp"
#include "verification/tests/temporary_directory.hpp"

namespace slosh::known_strengths_test {
namespace {

class KnownStrengthsTest : public ::testing::Test {
 protected:
  KnownStrengthsTest() : case_(surge_case()), runs_(surge_runs()) {
    case_.text = "name = \"surge\"\n[[gate]]\nlimit = 0.05\n[tank]\nlength_m = 1\n";
    case_.gate = {surge_row("forced", Metric::amplitude_error, "1", 0.05),
                  surge_row("forced", Metric::phase_lag, "deg", 5)};
  }
  std::filesystem::path file() const { return directory_.path() / "strengths.json"; }
  CaseAssessment assessment() const { return assess(case_, runs_); }
  // Finds out all rows' strengths and leaves the file.
  void report() const {
    KnownStrengths known(file(), "judge");
    row_strengths(assessment(), 1, &known);
    known.write();
  }
  // Which of the rows need not be found out again.
  std::vector<bool> known_rows(const std::string& judge = "judge") const {
    const KnownStrengths known(file(), judge);
    const CaseAssessment now = assessment();
    const std::string evidence = known.evidence_of(now);
    std::vector<bool> found;
    for (const GateOutcome& one : now.gate)
      found.push_back(known.find(evidence, one.row).has_value());
    return found;
  }

  CaseDefinition case_;
  CaseRuns runs_;
  TemporaryDirectory directory_;
};

using Rows = std::vector<bool>;

TEST_F(KnownStrengthsTest, AreThoseThatWereFoundOut) {
  report();
  KnownStrengths known(file(), "judge");
  const auto found = row_strengths(assessment(), 1), kept = row_strengths(assessment(), 1, &known);
  EXPECT_EQ(known_rows(), (Rows{true, true}));
  ASSERT_EQ(kept.size(), found.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_EQ(kept[i].strength.passes_as_it_is, found[i].strength.passes_as_it_is);
    ASSERT_EQ(kept[i].strength.outcomes.size(), found[i].strength.outcomes.size());
    for (std::size_t k = 0; k < found[i].strength.outcomes.size(); ++k) {
      const MutationOutcome &a = kept[i].strength.outcomes[k], &b = found[i].strength.outcomes[k];
      EXPECT_EQ(std::tie(a.mutation.kind, a.mutation.strength, a.mutation.mode, a.claimed,
                         a.detected, a.judged),
                std::tie(b.mutation.kind, b.mutation.strength, b.mutation.mode, b.claimed,
                         b.detected, b.judged));
    }
  }
}

// The file is believed: a row that is found in it is not tried.
TEST_F(KnownStrengthsTest, AreTakenWithoutATrial) {
  report();
  KnownStrengths known(file(), "judge");
  const CaseAssessment now = assessment();
  known.keep(known.evidence_of(now), now.gate[0].row, {true, {}});
  known.write();
  KnownStrengths again(file(), "judge");
  const auto strengths = row_strengths(now, 1, &again);
  ASSERT_EQ(strengths.size(), 2u);
  EXPECT_TRUE(strengths[0].strength.outcomes.empty());
  EXPECT_FALSE(strengths[1].strength.outcomes.empty());
}

TEST_F(KnownStrengthsTest, OfOtherRowsStayWhereOneRowChanges) {
  report();
  case_.gate[1].limit = 6;
  case_.text = "name = \"surge\"\n[[gate]]\nlimit = 0.06\n[tank]\nlength_m = 1\n";
  EXPECT_EQ(known_rows(), (Rows{true, false}));
}

TEST_F(KnownStrengthsTest, AreFoundOutAgainWhereTheJudgeTheCaseOrAResultChanges) {
  report();
  EXPECT_EQ(known_rows("another judge"), (Rows{false, false}));
  const std::string text = case_.text;
  case_.text = "name = \"surge\"\n[[gate]]\nlimit = 0.05\n[tank]\nlength_m = 2\n";
  EXPECT_EQ(known_rows(), (Rows{false, false}));
  case_.text = text;
  for (auto& [run, result] : runs_.results)
    if (!result.series.empty()) result.series[0].value.back() += 1e-12;
  EXPECT_EQ(known_rows(), (Rows{false, false}));
}

TEST_F(KnownStrengthsTest, OfADamagedFileAreNone) {
  report();
  std::ofstream(file()) << "{\"format_version\": 1, \"strengths\": {\"a\": 3}}";
  EXPECT_EQ(known_rows(), (Rows{false, false}));
  report();
  EXPECT_EQ(known_rows(), (Rows{true, true}));
}

}  // namespace
}  // namespace slosh::known_strengths_test

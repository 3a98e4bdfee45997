// The mutation trials that reports cache, and the changes after which they try again.
#include "verification/sensitivity/sensitivity_cache.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "verification/sensitivity/gate_sensitivity.hpp"
#include "verification/tests/field_results.hpp"
#include "verification/tests/surge_results.hpp"
#include "verification/tests/temporary_directory.hpp"

namespace slosh::sensitivity_cache_test {
namespace {

class SensitivityCacheTest : public ::testing::Test {
 protected:
  SensitivityCacheTest() : case_(surge_case()), runs_(surge_runs()) {
    case_.text = "name = \"surge\"\n[[gate]]\nlimit = 0.05\n[tank]\nlength_m = 1\n";
    case_.gate = {surge_row("forced", Metric::amplitude_error, "1", 0.05),
                  surge_row("forced", Metric::phase_lag, "deg", 5)};
  }
  std::filesystem::path file() const { return directory_.path() / "strengths.json"; }
  CaseAssessment assessment() const { return assess(case_, runs_); }
  // Tries all rows and writes the file.
  void report() const {
    SensitivityCache known(file(), "judge");
    gate_sensitivity(assessment(), &known);
    known.write();
  }
  // Which of the rows need not be found out again.
  std::vector<bool> known_rows(const std::string& judge = "judge") const {
    const SensitivityCache known(file(), judge);
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

TEST_F(SensitivityCacheTest, AreThoseThatWereFoundOut) {
  report();
  SensitivityCache known(file(), "judge");
  const auto found = gate_sensitivity(assessment()), kept = gate_sensitivity(assessment(), &known);
  EXPECT_EQ(known_rows(), (Rows{true, true}));
  ASSERT_EQ(kept.size(), found.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_EQ(kept[i].trials.passes_as_it_is, found[i].trials.passes_as_it_is);
    ASSERT_EQ(kept[i].trials.outcomes.size(), found[i].trials.outcomes.size());
    for (std::size_t k = 0; k < found[i].trials.outcomes.size(); ++k) {
      const MutationOutcome &a = kept[i].trials.outcomes[k], &b = found[i].trials.outcomes[k];
      EXPECT_EQ(std::tie(a.mutation.kind, a.mutation.strength, a.mutation.mode, a.claimed,
                         a.detected, a.judged),
                std::tie(b.mutation.kind, b.mutation.strength, b.mutation.mode, b.claimed,
                         b.detected, b.judged));
    }
  }
}

// The file is believed: a row that is found in it is not tried.
TEST_F(SensitivityCacheTest, AreTakenWithoutATrial) {
  report();
  SensitivityCache known(file(), "judge");
  const CaseAssessment now = assessment();
  known.keep(known.evidence_of(now), now.gate[0].row, {true, {}});
  known.write();
  SensitivityCache again(file(), "judge");
  const auto sensitivity = gate_sensitivity(now, &again);
  ASSERT_EQ(sensitivity.size(), 2u);
  EXPECT_TRUE(sensitivity[0].trials.outcomes.empty());
  EXPECT_FALSE(sensitivity[1].trials.outcomes.empty());
}

TEST_F(SensitivityCacheTest, OfOtherRowsStayWhereOneRowChanges) {
  report();
  case_.gate[1].limit = 6;
  case_.text = "name = \"surge\"\n[[gate]]\nlimit = 0.06\n[tank]\nlength_m = 1\n";
  EXPECT_EQ(known_rows(), (Rows{true, false}));
}

TEST_F(SensitivityCacheTest, AreFoundOutAgainWhereTheJudgeTheCaseOrAResultChanges) {
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

TEST_F(SensitivityCacheTest, AreFoundOutAgainWhereAFieldChanges) {
  FieldSnapshot& field = runs_.results.at("particles")
                             .snapshots.emplace_back(tiled_field(
                                 2, {0.1, 0.1}, [](double, double z) { return 1000 * z; }));
  report();
  EXPECT_EQ(known_rows(), (Rows{true, true}));
  field.pressure.back() += 1e-9;
  EXPECT_EQ(known_rows(), (Rows{false, false}));
}

TEST_F(SensitivityCacheTest, OfADamagedFileAreNone) {
  report();
  std::ofstream(file()) << "{\"format_version\": 1, \"strengths\": {\"a\": 3}}";
  EXPECT_EQ(known_rows(), (Rows{false, false}));
  report();
  EXPECT_EQ(known_rows(), (Rows{true, true}));
}

}  // namespace
}  // namespace slosh::sensitivity_cache_test

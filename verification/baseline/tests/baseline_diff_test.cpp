#include "verification/baseline/baseline_diff.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "verification/baseline/baseline_change.hpp"
#include "verification/tests/temporary_directory.hpp"

namespace slosh::baseline_diff_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
const std::string amplitude_row =
    "surge: sph against linear, forced amplitude_error of elevation@right";

GateOutcome outcome(double value, double half_width, double limit,
                    Verdict verdict = Verdict::pass) {
  GateOutcome result{};
  result.row.candidate = "sph";
  result.row.reference = "linear";
  result.row.quantity = "elevation@right";
  result.row.mode = "forced";
  result.row.metric = Metric::amplitude_error;
  result.row.unit = "1";
  result.row.limit = limit;
  result.verdict = verdict;
  result.value = {value, half_width};
  return result;
}

std::vector<CaseAssessment> campaign(const GateOutcome& row) {
  CaseAssessment assessment{};
  assessment.definition.name = "surge";
  assessment.gate = {row};
  return {assessment};
}

const Baseline baseline{{amplitude_row, {0.01, 0.003, -0.05, 0.05}}};

RowMovement movement(const GateOutcome& row) { return movements(baseline, campaign(row)).at(0); }

TEST(BaselineDiff, SaysByHowManyUncertaintiesAMetricHasMoved) {
  const RowMovement moved = movement(outcome(0.02, 0.004, 0.05));
  EXPECT_EQ(moved.row, amplitude_row);
  EXPECT_NEAR(moved.uncertainties, 0.01 / 0.005, 1e-12);
  EXPECT_TRUE(moved.has_changed());
  EXPECT_FALSE(moved.loosened);
  EXPECT_EQ(movement_text(moved), "+1 % -> +2 % (2 uncertainties)");
}

TEST(BaselineDiff, OfTheSameFiguresIsNone) {
  const RowMovement moved = movement(outcome(0.01, 0.003, 0.05));
  EXPECT_FALSE(moved.has_changed());
  EXPECT_EQ(moved.uncertainties, 0);
  EXPECT_EQ(movement_text(moved), "unmoved");
}

TEST(BaselineDiff, OfAChangeWithinTheIntervalsIsNone) {
  EXPECT_FALSE(movement(outcome(0.013, 0.003, 0.05)).has_changed());
  EXPECT_TRUE(movement(outcome(0.015, 0.003, 0.05)).has_changed());
  EXPECT_TRUE(proposed_changes({movement(outcome(0.013, 0.003, 0.05))}).empty());
}

TEST(BaselineDiff, OfWhatMachinesRoundDifferentlyIsNone) {
  const Baseline exact{{amplitude_row, {0.01, 0, -0.05, 0.05}}};
  EXPECT_FALSE(movements(exact, campaign(outcome(0.01 + 4e-8, 0, 0.05))).at(0).has_changed());
  EXPECT_TRUE(movements(exact, campaign(outcome(0.01 + 6e-8, 0, 0.05))).at(0).has_changed());
}

TEST(BaselineDiff, LeavesTimingsOut) {
  GateOutcome cost = outcome(3, 0.1, 5);
  cost.row.metric = Metric::cost_to_reach;
  EXPECT_TRUE(movements({}, campaign(cost)).empty());
}

TEST(BaselineDiff, TellsALoosenedToleranceEvenWhereNothingMoved) {
  const RowMovement moved = movement(outcome(0.01, 0.003, 0.06));
  EXPECT_TRUE(moved.loosened);
  EXPECT_EQ(movement_text(moved), "unmoved, tolerance loosened: -5 % .. +5 % -> -6 % .. +6 %");
  EXPECT_FALSE(movement(outcome(0.01, 0.003, 0.04)).loosened);
}

using Range = std::pair<double, double>;

TEST(BaselineDiff, CallsARangeThatIsNarrowerAtOneEndAndWiderAtTheOtherMoved) {
  GateOutcome shifted = outcome(0.05, 0, 0);
  shifted.row.limit = std::nullopt;
  shifted.row.between = Range{0.02, 0.12};
  const Baseline before{{amplitude_row, {0.05, 0, 0.0, 0.1}}};
  EXPECT_EQ(movement_text(movements(before, campaign(shifted)).at(0)),
            "unmoved, tolerance moved: +0 % .. +10 % -> +2 % .. +12 %");
}

bool is_loosened(Range before, std::optional<Range> after) {
  GateOutcome moved = outcome(0, 0, 0);
  moved.row.limit = std::nullopt;
  moved.row.between = after;
  return movements({{amplitude_row, {0, 0, before.first, before.second}}}, campaign(moved))
      .at(0)
      .loosened;
}

TEST(BaselineDiff, TellsARangeThatGrewAtOneEnd) {
  EXPECT_TRUE(is_loosened({0.1, 0.2}, Range{0.1, 0.3}));
  EXPECT_TRUE(is_loosened({0.1, 0.2}, Range{0.05, 0.2}));
  EXPECT_FALSE(is_loosened({0.1, 0.2}, Range{0.12, 0.2}));
  EXPECT_TRUE(is_loosened({-0.1, 0.1}, std::nullopt));
}

TEST(BaselineDiff, AValueThatIsNoNumberIsLostAndNotMoved) {
  const RowMovement lost = movement(outcome(nan, nan, 0.05, Verdict::not_compared));
  EXPECT_FALSE(lost.after.has_value());
  EXPECT_EQ(movement_text(lost), "no value any more");
  EXPECT_TRUE(proposed_changes({lost}).empty());
}

TEST(BaselineDiff, TellsALimitFromAnImprovementOfTheSameMetric) {
  GateRow row = outcome(0.01, 0.003, 0.05).row;
  row.limit.reset();
  row.improves_on = "coarse";
  EXPECT_EQ(row_name("surge", row), amplitude_row + ", below that of coarse");
}

TEST(BaselineDiff, AMetricWithoutIntervalsThatMovedDidSoBeyondAllUncertainty) {
  const Baseline exact{{amplitude_row, {0.01, 0, -0.05, 0.05}}};
  const auto moved = movements(exact, campaign(outcome(0.02, 0, 0.05))).at(0);
  EXPECT_TRUE(std::isinf(moved.uncertainties));
  EXPECT_EQ(movement_text(moved), "+1 % -> +2 % (no interval)");
}

TEST(BaselineDiff, WritesAsManyDigitsAsTellTheValuesApart) {
  const Baseline exact{{amplitude_row, {0.01, 0, -0.05, 0.05}}};
  const auto moved = movements(exact, campaign(outcome(0.0100004, 0, 0.05))).at(0);
  EXPECT_EQ(movement_text(moved), "+1 % -> +1.00004 % (no interval)");
}

TEST(BaselineDiff, LeavesAloneWhatThisFormOfTheCampaignLeavesOut) {
  EXPECT_TRUE(
      movements(baseline, campaign(outcome(nan, nan, 0.05, Verdict::not_selected))).empty());
  EXPECT_TRUE(
      movements(baseline, campaign(outcome(nan, nan, 0.05, Verdict::not_supplied))).empty());
}

TEST(BaselineDiff, ProposesToForgetARowThatIsNoLongerDeclared) {
  const auto gone = movements(baseline, {});
  ASSERT_EQ(gone.size(), 1U);
  EXPECT_EQ(movement_text(gone[0]), "no row any more");
  const auto changes = proposed_changes(gone);
  ASSERT_EQ(changes.size(), 1U);
  EXPECT_FALSE(changes[0].after.has_value());
}

TEST(BaselineProposal, OutlivesItsFile) {
  const TemporaryDirectory temporary;
  const auto file = temporary.path() / "proposal.json";
  const Proposal proposal{"surges", proposed_changes({movement(outcome(0.02, 0.004, 0.05))})};
  ASSERT_EQ(proposal.changes.size(), 1U);
  write_proposal(proposal, file);
  EXPECT_EQ(read_proposal(file).changes, proposal.changes);
  EXPECT_EQ(read_proposal(file).campaign, "surges");
}

TEST(BaselineProposal, ThatIsNotThereIsAnError) {
  EXPECT_THROW(read_proposal("/nowhere/proposal.json"), LedgerError);
}

}  // namespace
}  // namespace slosh::baseline_diff_test

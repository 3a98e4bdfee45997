#include "verification/baseline/baseline_diff.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <set>
#include <tuple>

#include "verification/baseline/baseline_ledger.hpp"
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
  assessment.definition.window_begin = assessment.definition.window_end = 0;
  assessment.gate = {row};
  return {assessment};
}

const Baseline baseline{{amplitude_row, {0.01, 0.003, -0.05, 0.05}}};

std::vector<RowMovement> moved_in(const Baseline& before, const std::vector<CaseAssessment>& cases,
                                  bool is_partial = false) {
  JudgedCampaign judged{cases, {}};
  if (is_partial)
    judged.selects = [](const CaseDefinition& of, const RunDefinition&) {
      return of.tags == std::vector<std::string>{"wave"};
    };
  return movements(before, judged);
}

RowMovement movement(const GateOutcome& row) { return moved_in(baseline, campaign(row)).at(0); }

TEST(BaselineDiff, SaysByHowManyUncertaintiesAMetricHasMoved) {
  const RowMovement moved = movement(outcome(0.02, 0.004, 0.05));
  EXPECT_EQ(moved.row, amplitude_row);
  EXPECT_NEAR(moved.uncertainties, 0.01 / 0.005, 1e-12);
  EXPECT_TRUE(moved.has_changed());
  EXPECT_FALSE(moved.loosened);
  EXPECT_EQ(movement_text(moved), "+1 % -> +2 % (2 uncertainties)");
}

// A limit of a cost times 1e9, and a row on one that is deleted.
TEST(BaselineDiff, KeepsTheToleranceOfACostAndNotItsTiming) {
  GateOutcome cost = outcome(3, 0.1, 5);
  cost.row.metric = Metric::cost_to_reach;
  const auto first = moved_in({}, campaign(cost));
  ASSERT_EQ(first.size(), 1U);
  EXPECT_FALSE(first[0].after->value.has_value());
  const Baseline before{{first[0].row, *first[0].after}};
  cost.value = {4, 0.1};
  EXPECT_FALSE(moved_in(before, campaign(cost)).at(0).has_changed());
  cost.row.limit = 5e9;
  const RowMovement moved = moved_in(before, campaign(cost)).at(0);
  EXPECT_TRUE(moved.has_changed());
  EXPECT_EQ(movement_text(moved),
            "no value, tolerance loosened: -500 % .. +500 % -> -5e+11 % .. "
            "+5e+11 %");
  EXPECT_TRUE(moved_in(before, {}).at(0).loses_validation());
}

TEST(BaselineDiff, KeepsARowThatNeverHadAValue) {
  const GateOutcome open = outcome(nan, nan, 0.05, Verdict::not_compared);
  const auto changes = proposed_changes(moved_in({}, campaign(open)));
  ASSERT_EQ(changes.size(), 1U);
  const Baseline before{{amplitude_row, changes[0].after.value()}};
  EXPECT_FALSE(moved_in(before, campaign(open)).at(0).has_changed());
  EXPECT_TRUE(moved_in(before, {}).at(0).loses_validation());
  const RowMovement first = moved_in(before, campaign(outcome(0.01, 0.003, 0.05))).at(0);
  EXPECT_TRUE(first.has_changed());
  EXPECT_EQ(movement_text(first), "first value: +1 %");
  const TemporaryDirectory temporary;
  write_proposal({"surges", changes}, temporary.path() / "proposal.json");
  EXPECT_EQ(read_proposal(temporary.path() / "proposal.json").changes, changes);
}

TEST(BaselineDiff, TellsALoosenedToleranceEvenWhereNothingMoved) {
  const RowMovement moved = movement(outcome(0.01, 0.003, 0.06));
  EXPECT_TRUE(moved.loosened);
  EXPECT_EQ(movement_text(moved), "unmoved, tolerance loosened: -5 % .. +5 % -> -6 % .. +6 %");
  const RowMovement tightened = movement(outcome(0.01, 0.003, 0.04));
  EXPECT_FALSE(tightened.loosened);
  EXPECT_EQ(movement_text(tightened), "unmoved, tolerance tightened: -5 % .. +5 % -> -4 % .. +4 %");
}

using Range = std::pair<double, double>;

TEST(BaselineDiff, CallsARangeThatIsNarrowerAtOneEndAndWiderAtTheOtherMoved) {
  GateOutcome shifted = outcome(0.05, 0, 0);
  shifted.row.limit = std::nullopt;
  shifted.row.between = Range{0.02, 0.12};
  const Baseline before{{amplitude_row, {0.05, 0, 0.0, 0.1}}};
  EXPECT_EQ(movement_text(moved_in(before, campaign(shifted)).at(0)),
            "unmoved, tolerance moved: +0 % .. +10 % -> +2 % .. +12 %");
}

bool is_loosened(Range before, std::optional<Range> after) {
  GateOutcome moved = outcome(0, 0, 0);
  moved.row.limit = std::nullopt;
  moved.row.between = after;
  return moved_in({{amplitude_row, {0, 0, before.first, before.second}}}, campaign(moved))
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
  EXPECT_FALSE(lost.lost());
  EXPECT_FALSE(lost.after->value.has_value());
  EXPECT_EQ(movement_text(lost), "no value any more");
  EXPECT_TRUE(proposed_changes({lost}).empty());
}

TEST(BaselineDiff, TellsALimitFromAnImprovementOfTheSameMetric) {
  GateRow row = outcome(0.01, 0.003, 0.05).row;
  row.limit.reset();
  row.improves_on = "coarse";
  EXPECT_EQ(row_name("surge", row), amplitude_row + ", below that of coarse");
}

TEST(BaselineDiff, IsOfWhatMovedBeyondIntervalsRoundingAndTheTwelfthDigitOfALimit) {
  const auto has_moved = [](double half_width, double value, double limit) {
    const Baseline before{{amplitude_row, {0.01, half_width, -0.05, 0.05}}};
    return moved_in(before, campaign(outcome(value, half_width, limit))).at(0).has_changed();
  };
  EXPECT_FALSE(has_moved(0.003, 0.01, 0.05));
  EXPECT_FALSE(has_moved(0.003, 0.013, 0.05));
  EXPECT_TRUE(has_moved(0.003, 0.015, 0.05));
  EXPECT_FALSE(has_moved(0, 0.01 + 4e-8, 0.05));
  EXPECT_TRUE(has_moved(0, 0.01 + 6e-8, 0.05));
  EXPECT_FALSE(has_moved(0.003, 0.01, 0.05 * (1 + 1e-12)));
  EXPECT_FALSE(has_moved(0.003, 0.01, 0.05 * (1 - 1e-12)));
  EXPECT_TRUE(has_moved(0.003, 0.01, 0.0501));
  EXPECT_TRUE(has_moved(0.003, 0.01, 0.0499));
}

TEST(BaselineDiff, WithoutIntervalsIsBeyondAllUncertaintyInAsManyDigitsAsItTakes) {
  const Baseline exact{{amplitude_row, {0.01, 0, -0.05, 0.05}}};
  const auto moved = moved_in(exact, campaign(outcome(0.02, 0, 0.05))).at(0);
  EXPECT_TRUE(std::isinf(moved.uncertainties));
  EXPECT_EQ(movement_text(moved), "+1 % -> +2 % (no interval)");
  EXPECT_EQ(movement_text(moved_in(exact, campaign(outcome(0.0100004, 0, 0.05))).at(0)),
            "+1 % -> +1.00004 % (no interval)");
}

TEST(BaselineDiff, LeavesAloneWhatASelectionLeavesOutAndWhatTheUserDoesNotHave) {
  constexpr bool is_partial = true;
  EXPECT_TRUE(
      moved_in(baseline, campaign(outcome(nan, nan, 0.05, Verdict::not_selected)), is_partial)
          .empty());
  const RowMovement missing = movement(outcome(nan, nan, 0.05, Verdict::not_supplied));
  EXPECT_FALSE(missing.has_changed());
  EXPECT_FALSE(missing.loses_validation());
  EXPECT_TRUE(proposed_changes({missing}).empty());
}

// Theory gives way to a record that nobody has.
TEST(BaselineDiff, ARowThatNowRestsOnARecordThatIsNotSuppliedIsLost) {
  std::vector<CaseAssessment> now = campaign(outcome(0.01, 0.003, 0.05));
  RunDefinition reference{};
  reference.name = "linear";
  reference.solver = PotentialRun{};
  now[0].definition.runs = {reference};
  const Baseline before{{amplitude_row, *moved_in({}, now).at(0).after}};
  RecordRun record{};
  record.file = "nowhere/x.csv";
  record.supplied = false;
  now[0].definition.runs[0].solver = record;
  now[0].gate = {outcome(nan, nan, 0.05, Verdict::not_supplied)};
  const RowMovement moved = moved_in(before, now).at(0);
  EXPECT_TRUE(moved.has_changed());
  EXPECT_TRUE(moved.loses_validation());
  EXPECT_NE(movement_text(moved).find("linear, the record x.csv"), std::string::npos)
      << movement_text(moved);
  const Baseline approved{{amplitude_row, proposed_changes({moved}).at(0).after.value()}};
  EXPECT_FALSE(moved_in(approved, now).at(0).loses_validation());
}

// The baseline of a form holds what that form judged: a run is no longer marked as quick.
TEST(BaselineDiff, ARowThatTheWholeFormLeavesOutIsLost) {
  const auto moved = moved_in(baseline, campaign(outcome(nan, nan, 0.05, Verdict::not_selected)));
  ASSERT_EQ(moved.size(), 1U);
  EXPECT_TRUE(moved[0].lost());
  EXPECT_TRUE(moved[0].loses_validation());
}

TEST(BaselineDiff, ARowWhoseCaseHasLostTheTagOfTheSelectionIsLost) {
  std::vector<CaseAssessment> now = campaign(outcome(0.01, 0.003, 0.05));
  RunDefinition candidate{};
  candidate.name = now[0].gate[0].row.candidate;
  now[0].definition.runs = {candidate};
  now[0].definition.tags = {"wave"};
  Baseline before{{amplitude_row, *moved_in({}, now).at(0).after}};
  EXPECT_FALSE(moved_in(before, now, true).at(0).has_changed());
  now[0].definition.tags = {};
  EXPECT_NE(movement_text(moved_in(before, now).at(0)).find(", tags: wave -> none"),
            std::string::npos);
  now[0].gate[0].verdict = Verdict::not_selected;
  const auto moved = moved_in(before, now, true);
  ASSERT_EQ(moved.size(), 1U);
  EXPECT_TRUE(moved[0].loses_validation());
  EXPECT_EQ(movement_text(moved[0]),
            "no row of this selection any more; its case had the tags wave");
  before.begin()->second.terms->tags = {"roll"};
  EXPECT_TRUE(moved_in(before, now, true).empty()) << "the selection never had it";
  before.begin()->second.terms->tags = {};  // an older ledger
  EXPECT_TRUE(moved_in(before, now, true).empty());
}

TEST(BaselineDiff, ProposesToForgetARowThatIsNoLongerDeclared) {
  const auto gone = moved_in(baseline, {});
  ASSERT_EQ(gone.size(), 1U);
  EXPECT_EQ(movement_text(gone[0]), "no row of this form any more");
  EXPECT_EQ(changes_sentence(gone), "Rows since the baseline: 1 lost (1 of validation).");
  const auto changes = proposed_changes(gone);
  ASSERT_EQ(changes.size(), 1U);
  EXPECT_FALSE(changes[0].after.has_value());
}

TEST(BaselineDiff, ALostRowOfRegressionLosesNoValidation) {
  Baseline before = baseline;
  before.begin()->second.terms = RowTerms{"regression", "", "", ""};
  const auto gone = moved_in(before, {});
  EXPECT_TRUE(gone.at(0).lost());
  EXPECT_FALSE(gone.at(0).loses_validation());
}

GateOutcome of_candidate(const std::string& name) {
  GateOutcome row = outcome(0.01, 0.003, 0.05);
  row.row.candidate = name;
  return row;
}

TEST(BaselineDiff, NamesTheRowThatALostOneMayBeNow) {
  const auto moved = moved_in(baseline, campaign(of_candidate("sph_2")));
  ASSERT_EQ(moved.size(), 2U);
  EXPECT_EQ(movement_text(moved[0]), "new: +1 %; it may have been " + amplitude_row);
  EXPECT_TRUE(moved[1].lost());
  EXPECT_EQ(moved[1].other_name, moved[0].row);
  GateOutcome other_metric = of_candidate("sph_2");
  other_metric.row.metric = Metric::phase_lag;
  EXPECT_EQ(moved_in(baseline, campaign(other_metric)).at(1).other_name, "");
}

TEST(BaselineDiff, TellsOtherTermsWhereTheBaselineRecordsThem) {
  Baseline before = baseline;
  before.begin()->second.terms = movement(outcome(0.01, 0.003, 0.05)).after->terms;
  std::vector<CaseAssessment> now = campaign(outcome(0.01, 0.003, 0.05));
  EXPECT_FALSE(moved_in(before, now).at(0).has_changed());
  now.front().definition.window_begin += 2;
  now.front().gate.front().row.kind = RowKind::regression;
  const RowMovement moved = moved_in(before, now).at(0);
  EXPECT_TRUE(moved.has_changed());
  EXPECT_TRUE(moved.loses_validation());
  const std::string text = movement_text(moved);
  EXPECT_NE(text.find("kind: validation -> regression, window: 0 .. 0 s -> 2 .. 0 s"), text.npos)
      << text;
}

TEST(BaselineDiff, TellsOtherEvidenceOfARow) {
  std::vector<CaseAssessment> now = campaign(outcome(0.01, 0.003, 0.05));
  CaseDefinition& definition = now[0].definition;
  definition.natural_modes = 2;
  definition.refinements = {{"spacing", RefinedNumber::particle_spacing, {"sph", "coarse"}}};
  RunDefinition theory{}, mine{};
  theory.name = "linear";
  theory.solver = LinearRun{10, false, 0.1};
  mine.name = "sph";
  mine.solver =
      ExternalRun{.command = {"./solve"}, .directory = "v1/tables", .inputs = {"mine.py"}};
  definition.runs = {theory, mine};
  Baseline before = baseline;
  before.begin()->second.terms = moved_in(baseline, now).at(0).after->terms;
  EXPECT_FALSE(moved_in(before, now).at(0).has_changed());
  const std::vector<std::function<void(CaseDefinition&)>> swaps{
      [](CaseDefinition& one) { one.natural_modes = 1; },
      [](CaseDefinition& one) { one.refinements[0].runs[1] = "other"; },
      [](CaseDefinition& one) { one.refinements.clear(); },
      [](CaseDefinition& one) {
        std::get<LinearRun>(one.runs[0].solver).valid_elevation_over_depth = 0.2;
      },
      [](CaseDefinition& one) { std::get<ExternalRun>(one.runs[1].solver).inputs.clear(); },
      [](CaseDefinition& one) {
        std::get<ExternalRun>(one.runs[1].solver).directory = "v2/tables";
      }};
  for (const auto& swap : swaps) {
    std::vector<CaseAssessment> other = now;
    swap(other[0].definition);
    const RowMovement moved = moved_in(before, other).at(0);
    EXPECT_TRUE(moved.has_changed());
    EXPECT_NE(movement_text(moved).find("rests on: 2 natural modes"), std::string::npos)
        << movement_text(moved);
  }
  before.begin()->second.terms->evidence.clear();  // an older ledger
  EXPECT_FALSE(moved_in(before, now).at(0).has_changed());
}

// The coarse run of a refinement decides u_num, and an input's run u_input.
TEST(BaselineDiff, TellsOtherSettingsOfARunThatTheRowRestsOn) {
  std::vector<CaseAssessment> now = campaign(outcome(0.01, 0.003, 0.05));
  CaseDefinition& definition = now[0].definition;
  RunDefinition mine{}, coarse{}, input{}, idle{};
  mine.name = "sph";
  coarse.name = "coarse";
  input.name = "at_bounds";
  idle.name = "idle";
  mine.solver = ExternalRun{.command = {"./solve", "1.01"}};
  coarse.solver = input.solver = idle.solver = ExternalRun{.command = {"./solve", "1.06"}};
  definition.runs = {mine, coarse, input, idle};
  definition.refinements = {{"spacing", RefinedNumber::particle_spacing, {"sph", "coarse"}}};
  definition.inputs = {{Input::amplitude, 0.001, "a ruler", "at_bounds"}};
  const Baseline before{{amplitude_row, *moved_in({}, now).at(0).after}};
  for (std::size_t i = 1; i < definition.runs.size(); ++i) {
    std::vector<CaseAssessment> other = now;
    std::get<ExternalRun>(other[0].definition.runs[i].solver).command[1] = "1.0101";
    EXPECT_EQ(moved_in(before, other).at(0).has_changed(), i < 3) << i;
  }
  Baseline older = before;  // with the first hash alone
  older.begin()->second.terms->setup.resize(32);
  const RowMovement moved = moved_in(older, now).at(0);
  EXPECT_FALSE(moved.has_changed());
  EXPECT_EQ(proposed_changes({moved}).at(0).after->terms->setup.size(), 65U);
}

// The same row, measured with these runs and a U of this half width.
GateOutcome measured_with(const std::set<std::string>& runs, double half_width,
                          const std::string& missing = "") {
  GateOutcome one = outcome(0.01, 0.003, 0.05);
  one.measured_with = runs;
  UncertaintyContributions contributions;
  contributions.input = half_width;
  contributions.input.not_counted = missing;
  one.judgement = judge_error(0.01, contributions, {-0.05, 0.05});
  return one;
}

std::vector<CaseAssessment> campaign_with_runs(const GateOutcome& row) {
  std::vector<CaseAssessment> cases = campaign(row);
  for (const char* name : {"linear", "sph", "coarse", "viscous", "repeat"}) {
    RunDefinition run{};
    run.name = name;
    run.solver = ExternalRun{.command = {"./solve", name}};
    cases[0].definition.runs.push_back(run);
  }
  return cases;
}

// The theory of the inputs is another one, repeats are gone, a coarse run is not part of the form.
TEST(BaselineDiff, TellsOtherRunsThatTheRowWasMeasuredWith) {
  const std::set<std::string> runs{"linear", "sph", "coarse", "repeat"};
  const std::vector<CaseAssessment> now = campaign_with_runs(measured_with(runs, 0.01));
  const Baseline before{{amplitude_row, *moved_in({}, now).at(0).after}};
  EXPECT_FALSE(moved_in(before, now).at(0).has_changed());
  for (const std::set<std::string>& others :
       {std::set<std::string>{"linear", "sph", "coarse"}, {"linear", "sph", "coarse", "viscous"}}) {
    const RowMovement moved =
        moved_in(before, campaign_with_runs(measured_with(others, 0.01))).at(0);
    EXPECT_TRUE(moved.has_changed());
    EXPECT_NE(movement_text(moved).find("measured with: coarse, linear, repeat, sph -> "),
              std::string::npos)
        << movement_text(moved);
  }
  std::vector<CaseAssessment> other = now;
  std::get<ExternalRun>(other[0].definition.runs.at(4).solver).command[1] = "1.1";
  EXPECT_TRUE(moved_in(before, other).at(0).has_changed()) << "other settings of a repeat";
  other = now;
  std::get<ExternalRun>(other[0].definition.runs.at(3).solver).command[1] = "1.1";
  EXPECT_FALSE(moved_in(before, other).at(0).has_changed()) << "of a run that decides nothing";
  other = now;
  other[0].gate = {outcome(nan, nan, 0.05, Verdict::solver_failed)};
  EXPECT_EQ(movement_text(moved_in(before, other).at(0)), "no value any more");
  EXPECT_TRUE(proposed_changes(moved_in(before, other)).empty());
  Baseline older = before;  // that recorded neither runs nor U
  older.begin()->second.uncertainty.reset();
  older.begin()->second.terms->measured_with.clear();
  older.begin()->second.terms->setup.resize(65);
  const std::vector<RowMovement> unmoved = moved_in(older, now);
  EXPECT_FALSE(unmoved.at(0).has_changed());
  EXPECT_EQ(proposed_changes(unmoved).at(0).after, before.begin()->second);
}

TEST(BaselineDiff, TellsAnIntervalThatShrankOrGrew) {
  constexpr double all = 0;
  for (const auto& [then, after, missing, text] :
       {std::tuple{0.49, 0.0001, "", "unmoved, U: 49 % -> 0.01 %"},
        {0.01, 0.03, "", "unmoved, U: 1 % -> 3 %"},
        {0.01, 0.01, "the sensitivity to depth is unknown", "unmoved, U: 1 % -> unknown"},
        {0.01, 0.0051, "", "unmoved"},    // by less than half
        {0.0004, 0.0001, "", "unmoved"},  // by less than a hundredth of 5 %
        {all, 0.0, "", "unmoved"}}) {
    const Baseline before{{amplitude_row, *movement(measured_with({"sph"}, then)).after}};
    const RowMovement moved =
        moved_in(before, campaign(measured_with({"sph"}, after, missing))).at(0);
    EXPECT_EQ(movement_text(moved), text);
    EXPECT_EQ(moved.has_changed(), movement_text(moved) != "unmoved");
    const TemporaryDirectory temporary;
    const std::vector<BaselineChange> changes{{moved.row, moved.before, moved.after}};
    write_proposal({"surges", changes}, temporary.path() / "proposal.json");
    EXPECT_EQ(read_proposal(temporary.path() / "proposal.json").changes, changes);
  }
}

TEST(BaselineDiff, ProposesTheTermsOfRowsThatHaveNotChanged) {
  const auto changes = proposed_changes({movement(outcome(0.0101, 0.003, 0.05))});
  ASSERT_EQ(changes.size(), 1U);
  EXPECT_EQ(changes[0].before, baseline.at(amplitude_row));
  EXPECT_EQ(changes[0].after->value, 0.01) << "the figures stand";
  EXPECT_EQ(changes[0].after->terms.value().kind, "validation");
  const TemporaryDirectory temporary;
  write_proposal({"surges", changes}, temporary.path() / "proposal.json");
  EXPECT_EQ(read_proposal(temporary.path() / "proposal.json").changes, changes);
}

TEST(BaselineDiff, KnowsTheRowsOfProblems) {
  ProblemAssessment problem{};
  problem.definition.name = "rigid_rotation";
  problem.gate = {{{"moment", ProblemMetric::error_at_finest, "1", 0.1, {}, "", "", {}},
                   Verdict::pass,
                   1e-9,
                   ""}};
  const std::string row = "rigid_rotation: error_at_finest of moment";
  const std::vector<CaseAssessment> none;
  const std::vector<ProblemAssessment> problems{problem};
  const auto found = movements({}, {none, problems});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].row, row);
  EXPECT_EQ(found[0].after->upper, 0.1);
  const Baseline known{{row, {2e-9, 1e-4, {}, 0.1}}};
  EXPECT_FALSE(movements(known, {none, problems}).at(0).has_changed()) << "round-off";
  EXPECT_TRUE(movements(known, {none, {}}).at(0).loses_validation());
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

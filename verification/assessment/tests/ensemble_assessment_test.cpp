// Rows on ensembles, judged, selected, tried and tabulated as a campaign does, on the small surge
// of surge_results.hpp.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "reports/tables/case_tables.hpp"
#include "verification/campaign/run_selection.hpp"
#include "verification/case/ensemble.hpp"
#include "verification/sensitivity/gate_sensitivity.hpp"
#include "verification/tests/impact_runs.hpp"
#include "verification/tests/surge_results.hpp"

namespace slosh::ensemble_assessment_test {
namespace {

// Three repeats of "particles", each too high by what is told, and one row on their amplitude.
struct Repeated {
  CaseDefinition definition = surge_case();
  CaseRuns runs = surge_runs();

  explicit Repeated(const std::vector<double>& errors, double limit) {
    RunDefinition first = run_named(definition, "particles");
    std::get<SphRun>(first.solver).start_disorder = 1e-6;
    const int count = static_cast<int>(errors.size());
    const auto members = ensemble_of(first, count, count);
    std::erase_if(definition.runs, [](const auto& run) { return run.name == "particles"; });
    definition.runs.insert(definition.runs.end(), members.begin(), members.end());
    for (std::size_t i = 0; i < errors.size(); ++i) {
      const std::string& name = members[i].name;
      runs.results[name] = result_of(name, scaled(elevation_of({}), 1 + errors[i]));
      runs.status[name] = {RunState::finished, ""};
    }
    definition.gate = {surge_row("forced", Metric::amplitude_error, "1", limit)};
  }
  CaseAssessment assessed() const { return assess(definition, runs); }
};

TEST(EnsembleAssessment, JudgesTheMeanByTheSpreadOfTheRepeats) {
  const GateOutcome outcome = Repeated({0.01, 0.02, 0.03}, 0.05).assessed().gate.at(0);
  EXPECT_NEAR(outcome.value.value, 0.02, 2e-4);
  EXPECT_NEAR(outcome.value.half_width, 4.30265 * 0.01 / std::sqrt(3.0), 2e-4);
  EXPECT_EQ(outcome.verdict, Verdict::pass);
  // Its contributions have the spread once: hand-written repeats add nothing to an ensemble.
  EXPECT_NEAR(outcome.judgement.value().contributions.time_series.known(), outcome.value.half_width,
              1e-12);
  EXPECT_EQ(Repeated({0.01, 0.02, 0.03}, 0.04).assessed().gate.at(0).verdict,
            Verdict::inconclusive);
  EXPECT_EQ(Repeated({0.10, 0.11, 0.12}, 0.05).assessed().gate.at(0).verdict, Verdict::violated);
}

// Peaks of impacts that come at other times in each repeat: the difference of two series is as
// large as the peak itself, and the peaks scatter by little.
TEST(EnsembleAssessment, JudgesALoadByTheScatterOfThePeaksThemselves) {
  Repeated repeated({0, 0, 0}, 0);
  GateRow row = surge_row("whole", Metric::largest_magnitude, "m", 0.8);
  row.reference.clear();
  repeated.definition.gate = {row};
  const double heights[] = {1, 1.02, 0.98};
  for (int i = 0; i < 3; ++i) {
    TimeSeries peaks = elevation_of({});
    for (std::size_t k = 0; k < peaks.time.size(); ++k)
      peaks.value[k] = heights[i] * std::exp(-std::pow((peaks.time[k] - 5 - i) / 0.1, 2));
    const std::string name = i == 0 ? "particles" : "particles_" + std::to_string(i + 1);
    repeated.runs.results[name] = result_of(name, peaks);
  }
  const GateOutcome outcome = repeated.assessed().gate.at(0);
  EXPECT_EQ(outcome.verdict, Verdict::violated) << outcome.message;
  EXPECT_NEAR(outcome.value.value, 1, 1e-9);
  EXPECT_NEAR(outcome.value.half_width, 4.30265 * 0.02 / std::sqrt(3.0), 1e-6);
  EXPECT_NE(outcome.message.find("mean over 3 repeats of 0.98 m to 1.02 m"), std::string::npos)
      << outcome.message;
}

// The magnitude of a difference does not tell a run that is too high from one that is too low:
// their series do, of an ensemble as of repeats that are written out.
TEST(EnsembleAssessment, CountsTheSpreadOfTheSeriesWhereTheMetricIsAMagnitude) {
  Repeated repeated({0.15, -0.15}, 0);
  repeated.definition.gate = {surge_row("whole", Metric::normalised_rms, "1", 0.2)};
  EXPECT_EQ(repeated.assessed().gate.at(0).verdict, Verdict::inconclusive);
  Repeated alike({0.0501, 0.05}, 0);
  alike.definition.gate = repeated.definition.gate;
  EXPECT_EQ(alike.assessed().gate.at(0).verdict, Verdict::pass);
  Repeated written({0.15, -0.15, 0.15, -0.15}, 0);
  for (RunDefinition& run : written.definition.runs) run.ensemble.clear();
  written.definition.gate = {surge_row("whole", Metric::normalised_rms, "1", 0.2)};
  const GateOutcome outcome = written.assessed().gate.at(0);
  EXPECT_EQ(outcome.verdict, Verdict::inconclusive);
  // t of three degrees of freedom, s = 0.15 sqrt(4 / 3), the interval of one more run of four.
  EXPECT_NEAR(outcome.judgement->contributions.time_series.known(),
              3.1824 * 0.15 * std::sqrt(4.0 / 3) * std::sqrt(1.25), 0.01);
}

TEST(EnsembleAssessment, IsNotComparedWithoutAMember) {
  Repeated repeated({0.01, 0.02, 0.03}, 0.05);
  repeated.runs.results.erase("particles_2");
  repeated.runs.status["particles_2"] = {RunState::missing, "its disk is full"};
  const GateOutcome outcome = repeated.assessed().gate.at(0);
  EXPECT_EQ(outcome.verdict, Verdict::not_compared);
  EXPECT_EQ(outcome.message, "the candidate particles_2 has no result: its disk is full");
}

TEST(EnsembleAssessment, MakesEveryMemberWrongInTheSelfTest) {
  // One wrong member of three would move the mean by a third of what is tried.
  const CaseAssessment assessment = Repeated({0.009, 0.010, 0.011}, 0.05).assessed();
  const auto sensitivity = gate_sensitivity(assessment);
  ASSERT_TRUE(sensitivity.at(0).passes_as_it_is);
  EXPECT_TRUE(sensitivity[0].detects.at(Spoiling::amplitude));
  EXPECT_TRUE(blind_rows(sensitivity).empty());
}

TEST(EnsembleAssessment, IsSelectedWholeWithARowOrWithout) {
  Repeated repeated({0.01, 0.02, 0.03}, 0.05);
  RunSelection selection;
  selection.only = {"small_surge/particles"};
  const auto run = [&](const char* name) { return run_named(repeated.definition, name); };
  for (const char* name : {"particles", "particles_2", "particles_3", "theory"})
    EXPECT_TRUE(is_selected(selection, repeated.definition, run(name))) << name;
  EXPECT_FALSE(is_selected(selection, repeated.definition, run("coarse_mesh")));
  repeated.definition.gate.clear();
  for (const char* name : {"particles", "particles_2", "particles_3"})
    EXPECT_TRUE(names_run(selection, repeated.definition, run(name))) << name;
  selection.only = {"small_surge/particles_2"};
  EXPECT_FALSE(names_run(selection, repeated.definition, run("particles")));
}

TEST(EnsembleAssessment, IsTabulatedWithItsSpread) {
  const CaseAssessment assessment = Repeated({0.01, 0.02, 0.03}, 0.05).assessed();
  for (const Comparison& comparison : assessment.comparisons)
    EXPECT_FALSE(is_later_member(run_named(assessment.definition, comparison.candidate)))
        << comparison.candidate;
  const reports::Table table = ensemble_table(assessment);
  ASSERT_EQ(table.rows.size(), 1U);
  EXPECT_EQ(table.rows[0].at(1), "3 x 1");
  EXPECT_EQ(table.rows[0].at(2), "2.0 ± 2.5 %");
  EXPECT_EQ(table.rows[0].at(3), "1 %");
  EXPECT_EQ(table.rows[0].at(4), "single run");
  EXPECT_EQ(table.rows[0].at(6), "pass");
  EXPECT_TRUE(ensemble_table(assess(surge_case(), surge_runs())).rows.empty());
}

// Peaks as those of the experiment's repeats, over an ensemble of 25, and a row of each metric on
// them.
CaseAssessment of_peaks() {
  CaseAssessment assessment = no_runs_of(impact_case());
  RunDefinition first{};
  first.name = "particles";
  SphRun sph{"recommended", 0.004, 0.004};
  sph.start_disorder = 0.05;
  first.solver = sph;
  CaseDefinition& definition = assessment.definition;
  definition.runs = ensemble_of(first, 25, 25);
  for (std::size_t k = 0; k < definition.runs.size(); ++k) {
    const std::string& name = definition.runs[k].name;
    assessment.runs.status[name] = {RunState::finished, ""};
    assessment.runs.results[name] =
        result_with(name, {pressure_of({.scale = 0.5 + static_cast<double>(k) / 24})});
  }
  for (const Metric metric : {Metric::peak_mean_p_value, Metric::peak_ks_p_value,
                              Metric::peak_ad_p_value, Metric::peak_median_error}) {
    GateRow row = surge_row("impact_4", metric, "1", 0.45);
    row.reference.clear();
    row.quantity = impact_pressure;
    row.kind = RowKind::regression;
    if (is_p_value(metric)) {
      row.limit.reset();
      row.between = {0.05, 1};
    }
    definition.gate.push_back(row);
  }
  return assess(definition, assessment.runs);
}

TEST(EnsembleAssessment, JudgesTheDistributionOfItsPeaksAndSeesItMadeWrong) {
  const CaseAssessment assessment = of_peaks();
  for (const GateOutcome& outcome : assessment.gate)
    EXPECT_EQ(outcome.verdict, Verdict::pass) << row_name(outcome.row) << outcome.message;
  EXPECT_TRUE(ensemble_table(assessment).rows.empty()) << "they are no means";
  for (const auto& [row, passes, detects] : gate_sensitivity(assessment))
    for (const Spoiling spoiling : {Spoiling::truncation, Spoiling::not_a_number})
      EXPECT_TRUE(detects.at(spoiling)) << row_name(row) << " " << spoiling_name(spoiling);
}

}  // namespace
}  // namespace slosh::ensemble_assessment_test

// A run against a published record that covers a part of the window: what is compared, and that it
// turns red on every way in which the run can be wrong.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "reports/pages/write_report.hpp"
#include "reports/summary/report_sections.hpp"
#include "verification/tests/messages.hpp"
#include "verification/tests/surge_results.hpp"

namespace slosh::record_assessment_test {
namespace {

constexpr double width = 0.1, acceleration = 2, duration = 1;  // [m], [m/s2], [s]

double front_at(double t) { return width + 0.5 * acceleration * t * t; }

TimeSeries front_series(double sampling, double scale = 1) {
  TimeSeries series{"front_position", "m", {}, {}};
  for (int i = 0; i * sampling <= duration * (1 + 1e-9); ++i) {
    series.time.push_back(i * sampling);
    series.value.push_back(scale * front_at(i * sampling));
  }
  return series;
}

GateRow front_row(Metric metric, const std::string& unit, double limit) {
  GateRow row = surge_row("whole", metric, unit, limit);
  row.reference = "published";
  row.quantity = "front_position";
  row.kind = RowKind::regression;  // of a run alone, without the coarser ones that tell its error
  return row;
}

// Sparse, irregular, from 0.2 to 0.8 s: less than the window at both ends.
RecordRun record() {
  RecordRun published{"front.csv", "front_position", "m", {0.2, 0.33, 0.41, 0.6, 0.71, 0.8}, {},
                      0.004};
  for (const double t : published.time) published.value.push_back(front_at(t));
  return published;
}

CaseDefinition dam_case() {
  CaseDefinition definition = surge_case();
  definition.liquid.column_width = width;
  definition.motion = {};
  definition.duration = duration;
  definition.window_begin = 0;
  definition.window_end = duration;
  definition.natural_modes = 0;
  RunDefinition published = sample_run(record());
  published.name = "published";
  RunDefinition particles = sample_run(SphRun{"recommended", 0.01, 0.01});
  particles.name = "particles";
  definition.runs = {published, particles};
  definition.gate = {front_row(Metric::normalised_rms, "1", 0.04),
                     front_row(Metric::mean_offset, "m", 0.02)};
  return definition;
}

CaseRuns dam_runs(const TimeSeries& front) {
  CaseRuns runs;
  RunResult published =
      result_of("published", {"front_position", "m", record().time, record().value});
  published.diagnostics.clear();
  runs.results["published"] = published;
  runs.results["particles"] = result_of("particles", front);
  TimeSeries elevation = front;
  elevation.name = surge_quantity;
  runs.results["particles"].series.push_back(elevation);
  for (const char* run : {"published", "particles"}) runs.status[run] = {RunState::finished, ""};
  return runs;
}

CaseAssessment assess_front(const TimeSeries& front) { return assess(dam_case(), dam_runs(front)); }

// Of the surge, whose row is on its elevation: a candidate against a record of this elevation.
CaseAssessment assess_surge(const TimeSeries& candidate, const RecordRun& record,
                            std::vector<GateRow> rows) {
  CaseDefinition definition = surge_case();
  RunDefinition published = sample_run(record);
  published.name = "published";
  definition.runs = {definition.runs.at(2), published};
  for (GateRow& row : rows) row.reference = "published";
  definition.gate = std::move(rows);
  CaseRuns runs;
  runs.results["particles"] = result_of("particles", candidate);
  runs.results["published"] =
      result_of("published", {surge_quantity, "m", record.time, record.value});
  for (const char* run : {"published", "particles"}) runs.status[run] = {RunState::finished, ""};
  return assess(definition, runs);
}

TimeSeries without(TimeSeries series, std::ptrdiff_t begin, std::ptrdiff_t end) {
  for (std::vector<double>* of : {&series.time, &series.value})
    of->erase(of->begin() + begin, of->begin() + end);
  return series;
}

// Expects the verdict and a part of the message of every row.
void expect_all(const CaseAssessment& assessment, Verdict verdict, const std::string& says = "") {
  for (const GateOutcome& outcome : assessment.gate) {
    EXPECT_EQ(outcome.verdict, verdict) << outcome.message;
    EXPECT_TRUE(holds(outcome.message, says));
  }
}

TEST(RecordAssessment, ComparesOverWhatTheRecordCovers) {
  const CaseAssessment assessment = assess_front(front_series(0.01));
  ASSERT_EQ(assessment.comparisons.size(), 1u);
  const Comparison& comparison = assessment.comparisons[0];
  EXPECT_EQ(comparison.candidate, "particles");
  EXPECT_EQ(comparison.reference, "published");
  EXPECT_EQ(comparison.quantity, "front_position");
  EXPECT_EQ(comparison.window.begin, 0.2);
  EXPECT_EQ(comparison.window.end, 0.8);
  EXPECT_EQ(comparison.residual.time, record().time);
  EXPECT_LT(comparison.maximum_residual, 1e-4);
  EXPECT_TRUE(comparison.modes.empty());
  EXPECT_EQ(exit_status({assessment}), exit_pass);
}

TEST(RecordAssessment, TellsHowMuchOfTheWindowTheRecordCoversAndNeedsHalfOfIt) {
  expect_all(assess_front(front_series(0.01)), Verdict::pass,
             "; over 60 % of the window, which the samples cover");
  CaseDefinition definition = dam_case();
  RecordRun& published = std::get<RecordRun>(definition.runs[0].solver);
  published.time.resize(4);  // to 0.6 s
  published.value.resize(4);
  CaseRuns runs = dam_runs(front_series(0.01));
  runs.results["published"] =
      result_of("published", {"front_position", "m", published.time, published.value});
  expect_all(assess(definition, runs), Verdict::not_compared,
             "the samples cover 40 % of the window; expected half");
  for (double& time : published.time) time += 5;
  expect_all(assess(definition, dam_runs(front_series(0.01))), Verdict::not_compared,
             "published: the record covers 5.2 s to 5.6 s; expected a part of 0 s to 1 s");
}

TEST(RecordAssessment, CountsTheRecordsUncertaintyForEveryMetric) {
  CaseDefinition definition = dam_case();
  definition.gate.push_back(front_row(Metric::aligned_rms, "1", 0.1));
  definition.gate.push_back(front_row(Metric::mean_offset, "m", 0.003));
  for (GateRow& row : definition.gate) row.kind = RowKind::validation;
  const CaseAssessment assessment = assess(definition, dam_runs(front_series(0.01)));
  ASSERT_EQ(assessment.gate.size(), 4U);
  for (const GateOutcome& outcome : assessment.gate)
    EXPECT_GT(outcome.judgement.value().contributions.reference.half_width.value(), 0)
        << metric_name(outcome.row.metric);
  // A record too high by 4 mm leaves an offset of that.
  EXPECT_NEAR(assessment.gate[1].judgement->contributions.reference.known(), 0.004, 1e-4);
  EXPECT_EQ(assessment.gate[3].verdict, Verdict::inconclusive);
  EXPECT_TRUE(holds(assessment.gate[3].message, "cannot be distinguished from 0.003 m"));
}

TEST(RecordAssessment, OfAnEarlierRunIsForTheRowsThatAskForItAlone) {
  CaseDefinition definition = dam_case();
  std::get<RecordRun>(definition.runs[0].solver).earlier_run = true;
  for (GateRow& row : definition.gate) row.kind = RowKind::regression;
  const CaseAssessment assessment = assess(definition, dam_runs(front_series(0.01)));
  EXPECT_TRUE(assessment.comparisons.empty());
  EXPECT_EQ(series_of_record(assessment, "front_position"), nullptr);
  EXPECT_EQ(exit_status({assessment}), exit_pass);
  const CaseAssessment scaled = assess(definition, dam_runs(front_series(0.01, 1.05)));
  EXPECT_EQ(exit_status({scaled}), exit_violated);
}

TEST(RecordAssessment, StaysWithinTheCasesWindow) {
  CaseDefinition definition = dam_case();
  definition.window_begin = 0.3;
  definition.window_end = 0.75;
  EXPECT_EQ(assess(definition, dam_runs(front_series(0.01))).comparisons.at(0).residual.time,
            (std::vector<double>{0.33, 0.41, 0.6, 0.71}));
  definition.window_begin = 0.85;  // the record ends before it
  definition.window_end = duration;
  EXPECT_EQ(exit_status({assess(definition, dam_runs(front_series(0.01)))}), exit_not_compared);
}

TEST(RecordAssessment, RejectsAFrontThatIsScaledAndComparesNoneThatIsCutBrokenOrAbsent) {
  const CaseAssessment scaled = assess_front(front_series(0.01, 1.08));
  expect_all(scaled, Verdict::violated);
  EXPECT_EQ(exit_status({scaled}), exit_violated);
  TimeSeries broken = front_series(0.01);
  broken.value[5] = std::numeric_limits<double>::quiet_NaN();
  CaseRuns without_front = dam_runs(front_series(0.01));
  auto& series = without_front.results["particles"].series;
  series.erase(series.begin());
  for (const CaseAssessment& assessment :
       {assess_front(without(front_series(0.01), 70, 101)), assess_front(broken),
        assess(dam_case(), without_front)}) {
    expect_all(assessment, Verdict::not_compared);
    EXPECT_FALSE(assessment.not_comparable.empty());
    EXPECT_EQ(exit_status({assessment}), exit_not_compared);
  }
  EXPECT_TRUE(holds(assess(dam_case(), without_front).not_comparable.at(0),
                    "has no series front_position"));
}

TEST(RecordAssessment, SetsTwoSolversSideBySideOnFrontAndElevation) {
  CaseDefinition definition = dam_case();
  RunDefinition mesh = sample_run(InterFoamRun{50, 50, 1});
  mesh.name = "mesh";
  definition.runs.push_back(mesh);
  CaseRuns runs = dam_runs(front_series(0.01));
  runs.results["mesh"] = runs.results["particles"];
  runs.status["mesh"] = {RunState::finished, ""};
  std::vector<std::string> compared;
  for (const Comparison& one : assess(definition, runs).comparisons)
    compared.push_back(one.candidate + " " + one.reference + " " + one.quantity);
  EXPECT_EQ(compared, (std::vector<std::string>{
                          "particles published front_position", "particles mesh front_position",
                          "particles mesh elevation@right", "mesh published front_position"}));
}

TEST(RecordAssessment, ComparesTheHistoriesAloneWhereTheRecordIsTooSparseForModes) {
  RecordRun sparse{"elevation.csv", surge_quantity, "m", {}, {}, 1e-6};
  const TimeSeries truth = elevation_of({});
  for (std::size_t i = 50; i < 450; i += 38) {
    sparse.time.push_back(truth.time[i]);
    sparse.value.push_back(truth.value[i]);
  }
  std::vector<GateRow> rows{surge_row("whole", Metric::normalised_rms, "1", 0.01),
                            surge_row("forced", Metric::amplitude_error, "1", 0.05)};
  for (GateRow& row : rows) row.kind = RowKind::regression;
  const CaseAssessment assessment = assess_surge(truth, sparse, rows);
  EXPECT_EQ(assessment.gate[0].verdict, Verdict::pass) << assessment.gate[0].message;
  EXPECT_EQ(assessment.gate[1].verdict, Verdict::not_compared);
  EXPECT_EQ(assessment.gate[1].message, "the mode forced was not fitted");
}

// A record that carries the modes, and a candidate with a hole of 1.5 s: that is the candidate's
// fault, and no row may pass on what is left.
TEST(RecordAssessment, TellsOfAHoleInTheCandidateAndDropsNoModeForIt) {
  const TimeSeries truth = elevation_of({});
  expect_all(assess_surge(without(truth, 200, 275),
                          {"elevation.csv", surge_quantity, "m", truth.time, truth.value, {}},
                          {surge_row("whole", Metric::normalised_rms, "1", 0.5),
                           surge_row("forced", Metric::amplitude_error, "1", 0.05)}),
             Verdict::not_compared, "candidate elevation@right: no sample between");
}

TEST(RecordReport, DrawsTheRecordAsPointsWithItsUncertainty) {
  const CampaignDefinition campaign{"dams", "Dams", "none", "", {}, "", "dams.toml"};
  const reports::Report report =
      campaign_report(campaign, false, "./slosh campaign dams", {assess_front(front_series(0.01))});
  EXPECT_NO_THROW(reports::check_report(report));
  std::vector<reports::Figure> figures;
  for (const reports::Section& section : report.sections)
    figures.insert(figures.end(), section.figures.begin(), section.figures.end());
  const auto found = std::find_if(figures.begin(), figures.end(), [](const auto& figure) {
    return figure.y_label == "front position [mm]";
  });
  ASSERT_NE(found, figures.end());
  const reports::Figure& history = *found;
  EXPECT_EQ(history.curves.at(0).label, "published");
  EXPECT_EQ(history.curves[0].style, reports::Curve::Style::points);
  EXPECT_EQ(history.curves[0].y_error, std::vector<double>(6, 4.0));
  for (const reports::Figure& figure : figures)
    EXPECT_EQ(figure.id.find("spectrum"), std::string::npos) << "there is no tone to look for";
}

RecordRun record_with_band() {
  RecordRun published = record();
  published.has_band = true;
  for (const double value : published.value) {
    published.lower.push_back(value - 0.01);
    published.upper.push_back(value + 0.02);
  }
  return published;
}

// The rows on the band, the first over all of it and the second over its end.
CaseDefinition banded_case() {
  CaseDefinition definition = dam_case();
  definition.runs[0].solver = record_with_band();
  definition.gate = {front_row(Metric::outside_band, "1", 0.2),
                     front_row(Metric::outside_band, "1", 0.1)};
  definition.gate[1].part = {0.3, 0.8};
  return definition;
}

CaseAssessment assess_banded(const TimeSeries& front, CaseDefinition definition = banded_case()) {
  CaseRuns runs = dam_runs(front);
  const RecordRun published = record_with_band();
  for (const auto& [edge, value] :
       {std::pair{"/lower", published.lower}, {"/upper", published.upper}})
    runs.results.at("published")
        .series.push_back({std::string("front_position") + edge, "m", published.time, value});
  return assess(std::move(definition), std::move(runs));
}

TEST(RecordAssessment, JudgesACandidateInTheBandOfTheRepeats) {
  const CaseAssessment inside = assess_banded(front_series(0.01));
  for (const GateOutcome& outcome : inside.gate) {
    EXPECT_EQ(outcome.verdict, Verdict::pass) << outcome.message;
    EXPECT_EQ(outcome.value.value, 0);
  }
  EXPECT_EQ(row_name(inside.gate.at(1).row),
            "particles against published, whole outside_band from 0.3 to 0.8 s of front_position");
}

TEST(RecordAssessment, ViolatesRowsOnTheBandByWhatLeavesIt) {
  // 5 % too far is 0.037 m at 0.8 s: outside from about 0.55 s on.
  const CaseAssessment scaled = assess_banded(front_series(0.01, 1.05));
  expect_all(scaled, Verdict::violated);
  EXPECT_GT(scaled.gate[1].value.value, scaled.gate[0].value.value);
  TimeSeries late = front_series(0.01), poisoned = late;
  for (double& time : late.time) time += 0.05;
  late.time.front() = 0;
  EXPECT_EQ(assess_banded(late).gate.at(0).verdict, Verdict::violated);
  poisoned.value[60] = std::numeric_limits<double>::quiet_NaN();
  for (const TimeSeries& front : {poisoned, without(front_series(0.01), 60, 101)})
    expect_all(assess_banded(front), Verdict::not_compared);
  expect_all(assess(banded_case(), dam_runs(front_series(0.01))), Verdict::not_compared,
             "published has no band for front_position");
}

TEST(RecordAssessment, KnowsTheBandAsTheSpreadOfTheRepeats) {
  CaseDefinition definition = banded_case();
  for (GateRow& row : definition.gate) row.kind = RowKind::validation;
  const CaseAssessment assessment = assess_banded(front_series(0.01), definition);
  for (const GateOutcome& outcome : assessment.gate)
    EXPECT_EQ(outcome.judgement.value().contributions.reference.half_width.value(), 0);
  // The candidate's numerical uncertainty is still unknown.
  EXPECT_EQ(assessment.gate.at(0).verdict, Verdict::inconclusive);
}

}  // namespace
}  // namespace slosh::record_assessment_test

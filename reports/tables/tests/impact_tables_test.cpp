// The table of impacts: the published row and the record on top, every run's numbers, and what is
// said where there are none. Runs that repeat one another: which they are, and their peaks'
// distribution beside the experiment's.
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <limits>

#include "reports/tables/case_tables.hpp"
#include "verification/assessment/across_runs/impact_samples.hpp"
#include "verification/gate/impact_metrics.hpp"
#include "verification/tests/impact_runs.hpp"
#include "verification/tests/messages.hpp"

namespace slosh::impact_tables_test {
namespace {

const SphRun sph{"recommended", 0.004, 0.004};

using Row = std::vector<std::string>;

CaseAssessment one_run(const TimeSeries& pressure, const CaseDefinition& definition) {
  CaseAssessment assessment = no_runs_of(definition);
  add_run(assessment, "particles", sph, {pressure});
  return assessment;
}

TEST(ImpactTable, GivesTimesPeaksPercentilesAndPlateau) {
  const reports::Table table =
      impact_table(one_run(pressure_of({.late = 0.012, .scale = 1.1}), impact_case()));
  EXPECT_EQ(table.header,
            (Row{"run", "pressure", "impact 1 [s]", "peak 1 [Pa]", "rise 1 [s]", "impact 2 [s]",
                 "peak 2 [Pa]", "rise 2 [s]", "impact 3 [s]", "peak 3 [Pa]", "rise 3 [s]",
                 "impact 4 [s]", "peak 4 [Pa]", "rise 4 [s]", "plateau [Pa]"}));
  ASSERT_EQ(table.rows.size(), 2u);
  EXPECT_EQ(table.rows[0],
            (Row{"published", "mean ± sd of the repeats", "2.375", "3710 ± 732", "not published",
                 "4.073", "4816 ± 1501", "not published", "5.718", "4691 ± 1706", "not published",
                 "7.303", "4643 ± 1323", "not published", "670"}));
  EXPECT_EQ(table.rows[1],
            (Row{"particles", "unfiltered", "2.387 (+0.012)", "4081 (60 %)", "0.0040",
                 "4.085 (+0.012)", "5298 (60 %)", "0.0042", "5.730 (+0.012)", "5160 (60 %)",
                 "0.0042", "7.315 (+0.012)", "5107 (60 %)", "0.0042", "737 (+10 %)"}));
  CaseDefinition definition = impact_case();
  definition.impacts->repeats.clear();  // deviations count where they are not supplied
  const reports::Table without = impact_table(one_run(pressure_of({.scale = 1.1}), definition));
  EXPECT_EQ(without.rows.at(1).at(3), "4081 (+0.5 sd)");
  EXPECT_TRUE(holds(without.caption, "not supplied"));
}

TEST(ImpactTable, HasARowForTheFilteredPressureWhichIsLateAgainstTheRecordOnTop) {
  CaseDefinition definition = impact_case();
  definition.pressure_gauges[0].filter_cutoff = 50;
  const std::string filtered = impact_pressure + "/filtered";
  CaseAssessment assessment = no_runs_of(definition);
  add_run(assessment, "particles", sph,
          {pressure_of({}), pressure_of({.late = 0.012, .scale = 0.9, .name = filtered})});
  EXPECT_EQ(impact_table(assessment).rows.at(2).at(2), "2.387");
  add_run(assessment, "measured", RecordRun{"a.csv", impact_pressure, "Pa", {0, 8}, {0, 0}, {}},
          {pressure_of({}), pressure_of({.late = 0.002, .name = filtered})});
  const auto rows = impact_table(assessment).rows;
  EXPECT_EQ(rows.at(1)[0], "measured");
  const auto unfiltered = std::ranges::find_if(
      rows, [](const Row& row) { return row[0] == "particles" && row[1] == "unfiltered"; });
  ASSERT_NE(unfiltered, rows.end());
  const Row& after = *std::next(unfiltered);
  EXPECT_EQ(after[1], "filtered");
  EXPECT_EQ(after[2], "2.387 (+0.010)");
  EXPECT_EQ(after[3], "3339 (40 %)");
}

TEST(ImpactTable, SaysWhatDoesNotOccurOrIsNaNOrHasNoResult) {
  CaseAssessment assessment = one_run(pressure_of({.impacts = 1}), impact_case());
  TimeSeries poisoned = pressure_of({});
  poisoned.value[2500] = std::numeric_limits<double>::quiet_NaN();
  add_run(assessment, "poisoned", sph, {poisoned});
  add_absent_run(assessment, "gone", sph, RunState::failed);
  const auto rows = impact_table(assessment).rows;
  EXPECT_EQ(rows.at(1).at(5), "no impact");
  EXPECT_TRUE(holds(rows.at(2).at(2), "not finite"));
  EXPECT_EQ(rows[2].back(), "not available");
  EXPECT_EQ(rows.at(3).at(1), "solver failed");
  for (const Row& row : rows) EXPECT_EQ(row.size(), rows[0].size());
}

TEST(ImpactTable, OfASingleImpactTellsItsArrivalAndItsImpulse) {
  CaseDefinition definition = impact_case();
  ImpactsDefinition single = *definition.impacts;
  single.times = {2.375};
  single.peak_means = {3710};
  single.peak_deviations.clear();
  single.repeats.clear();
  single.plateau = single.plateau_begin = single.plateau_end = 0;
  single.arrivals = ArrivalsDefinition{.share = 0.5, .times = {2.374}};
  single.impulses = ImpulsesDefinition{.duration = 0.07, .values = {50}};
  single.rise_times = RiseTimesDefinition{{0.001}, 0.0002};
  definition.impacts = single;
  CaseAssessment assessment = one_run(pressure_of({.late = 0.012}), definition);
  add_run(assessment, "dry", sph, {pressure_of({.impacts = 0})});
  const reports::Table table = impact_table(assessment);
  EXPECT_EQ(table.header, (Row{"run", "pressure", "impact 1 [s]", "peak 1 [Pa]", "rise 1 [s]",
                               "arrival 1 [s]", "impulse 1 [Pa s]"}));
  EXPECT_EQ(table.rows.at(0),
            (Row{"published", "as published", "2.375", "3710", "0.0010 ± 0.0002", "2.3740", "50"}));
  const Row& run = table.rows.at(1);
  EXPECT_EQ(run.at(2), "2.387 (+0.012)");
  EXPECT_EQ(run.at(3), "3710 (+0 %)");
  EXPECT_EQ(run.at(4), "0.0040 (+0.0030)");
  EXPECT_TRUE(begins(run.at(5), "2.38"));
  EXPECT_TRUE(holds(run.at(6), " %)"));
  EXPECT_EQ(table.rows.at(2).at(2), "no impact");
  for (const Row& row : table.rows) EXPECT_EQ(row.size(), table.header.size());
  EXPECT_TRUE(holds(table.caption,
                    "Arrival: when the pressure comes to 0.5 of the published peak "
                    "and holds it"));
  EXPECT_FALSE(holds(table.caption, "Plateau"));
}

// Through the whole assessment: the rows find their series, filtered ones included.
CaseAssessment assessed(const TimeSeries& pressure) {
  CaseDefinition definition = impact_case();
  definition.pressure_gauges[0].filter_cutoff = 50;
  definition.impacts->arrivals = ArrivalsDefinition{.share = 0.5, .times = {}};
  for (std::size_t n = 0; n < definition.impacts->times.size(); ++n)
    definition.impacts->arrivals->times.push_back(
        arrival_in(pressure_of({}), n, definition).value());
  for (const char* filtered : {"", "/filtered"}) {
    GateRow row{};
    row.candidate = "particles";
    row.quantity = impact_pressure + filtered;
    row.mode = "impact_2";
    row.metric = Metric::impact_arrival;
    row.unit = "s";
    row.limit = 0.05;
    row.kind = RowKind::regression;  // neither side declares its uncertainty
    definition.gate.push_back(row);
  }
  CaseAssessment made = one_run(pressure, definition);
  add_run(made, "measured", RecordRun{"a.csv", impact_pressure, "Pa", {0, 8}, {0, 0}, {}},
          {pressure_of({})});
  return assess(made.definition, made.runs);
}

TEST(CaseWithImpacts, IsGatedOnThePressureAsItIsAndFiltered) {
  for (const GateOutcome& outcome : assessed(pressure_of({.late = 0.012})).gate) {
    EXPECT_EQ(outcome.verdict, Verdict::pass) << outcome.message;
    EXPECT_NEAR(outcome.value.value, 0.012, 0.002);
  }
  for (const GateOutcome& outcome : assessed(pressure_of({.late = 0.06})).gate)
    EXPECT_EQ(outcome.verdict, Verdict::violated) << outcome.message;
  for (const GateOutcome& outcome : assessed(pressure_of({.until = 4})).gate)
    EXPECT_EQ(outcome.verdict, Verdict::not_compared) << outcome.message;
}

SphRun repeat(int seed, double spacing = 0.004) {
  SphRun sph{"recommended", spacing, spacing};
  sph.start_disorder = 0.05;
  sph.start_seed = seed;
  return sph;
}

// Peaks of a n-th run of 40: as the experiment's n-th repeat, times a scale.
CaseAssessment repeats(int count, double scale = 1) {
  CaseAssessment assessment = no_runs_of(impact_case());
  add_run(assessment, "ordered", SphRun{"recommended", 0.004, 0.004}, {pressure_of({})});
  for (int i = 0; i < count; ++i)
    add_run(assessment, "repeat_" + std::to_string(i), repeat(i),
            {pressure_of({.scale = scale * (0.5 + i / 39.0)})});
  return assessment;
}

TEST(RepeatedRuns, DifferInTheirSeedAlone) {
  CaseAssessment assessment = repeats(3);
  add_run(assessment, "finer", repeat(1, 0.002), {});
  SphRun other = repeat(2);
  other.start_disorder = 0.1;
  add_run(assessment, "wilder", other, {});
  const auto groups = repeated_runs(assessment.definition);
  ASSERT_EQ(groups.size(), 1u);
  ASSERT_EQ(groups[0].size(), 3u);
  EXPECT_EQ(groups[0][2]->name, "repeat_2");
}

TEST(RepeatedRuns, AreTheMembersOfAnEnsembleWhateverItsSolver) {
  CaseAssessment assessment = repeats(2);
  for (const char* name : {"mesh", "mesh_2"}) {
    add_run(assessment, name, InterFoamRun{80, 30}, {});
    assessment.definition.runs.back().ensemble = "mesh";
    assessment.definition.runs.back().varies_inputs = true;
  }
  // Its inputs are its own: it repeats none of the runs that are alike but for the seed.
  for (const char* name : {"drawn", "drawn_2"}) {
    add_run(assessment, name, repeat(*name + static_cast<int>(std::string(name).size())), {});
    assessment.definition.runs.back().ensemble = "drawn";
    assessment.definition.runs.back().varies_inputs = true;
  }
  const auto groups = repeated_runs(assessment.definition);
  ASSERT_EQ(groups.size(), 3u);
  EXPECT_EQ(groups[0].front()->name, "repeat_0");
  EXPECT_EQ(groups[1].back()->name, "mesh_2");
  EXPECT_EQ(groups[2].back()->name, "drawn_2");
  for (const auto& group : groups) EXPECT_EQ(group.size(), 2u);
}

// A mean over three repeats has the half width t s / sqrt(3) with t = 4.30; of thirteen t is 2.18.
TEST(RemedyText, CountsTheRepeatsThatAnEnsembleLacksAndLengthensTheWindowOfARun) {
  CaseAssessment assessment = repeats(1);
  for (int i = 1; i <= 3; ++i) {
    add_run(assessment, "wild_" + std::to_string(i), repeat(i), {});
    assessment.definition.runs.back().ensemble = "wild_1";
  }
  UncertaintyContributions known;
  known.time_series = 4e4;
  GateOutcome outcome{};
  outcome.verdict = Verdict::inconclusive;
  outcome.row.metric = Metric::largest_magnitude;
  outcome.judgement = judge_error(7e4, known, {-6e4, 6e4});
  outcome.row.candidate = "wild_1";
  EXPECT_EQ(remedy_text(assessment.definition, outcome),
            "13 repeats of the candidate in place of 3, if they scatter alike");
  outcome.row.candidate = "ordered";
  EXPECT_EQ(remedy_text(assessment.definition, outcome),
            "a window 16 times as long, at 16 times the cost");
}

TEST(RepeatTable, GivesTheDistributionBesideTheExperiments) {
  const reports::Table table = repeat_table(repeats(40));
  ASSERT_EQ(table.rows.size(), 8u);
  const auto& experiment = table.rows[0];
  const auto& runs = table.rows[1];
  EXPECT_EQ(experiment.at(0), "experiment");
  EXPECT_EQ(runs.at(0), "repeat_0 to repeat_39");
  EXPECT_EQ(runs.at(3), "40 of 40");
  EXPECT_EQ(experiment.at(4), "3700 ± 400") << "t s / sqrt(40), s = 1112 Pa: 3710 +- 356";
  for (const std::size_t column : {4u, 5u, 6u}) EXPECT_EQ(runs.at(column), experiment.at(column));
  EXPECT_TRUE(begins(runs.at(7), "1.00 (0."));
  for (const std::size_t column : {8u, 9u, 10u}) EXPECT_EQ(runs.at(column), "1");
  const auto scaled = repeat_table(repeats(40, 1.1)).rows;
  EXPECT_TRUE(begins(scaled.at(1).at(7), "1.10 ("));
  EXPECT_EQ(scaled.at(1).at(8), "0.16") << "Welch: 371 Pa over 261 Pa, 77 degrees of freedom";
}

TEST(RepeatTable, SaysWhatIsMissing) {
  CaseAssessment assessment = repeats(5);
  assessment.definition.impacts->repeats.clear();
  add_absent_run(assessment, "repeat_failed", repeat(40), RunState::failed);
  TimeSeries poisoned = pressure_of({});
  poisoned.value[2500] = std::numeric_limits<double>::quiet_NaN();
  add_run(assessment, "repeat_poisoned", repeat(41), {poisoned});
  add_run(assessment, "repeat_lame", repeat(42), {pressure_of({.impacts = 1})});
  const auto rows = repeat_table(assessment).rows;
  EXPECT_EQ(rows.at(0).at(6), "not supplied");
  EXPECT_EQ(rows.at(1).at(3), "6 of 6");
  EXPECT_EQ(rows.at(3).at(3), "5 of 6");
  EXPECT_EQ(rows.at(1).at(6), "fewer than 20 peaks");
  EXPECT_EQ(rows.at(1).at(7), "not supplied");
  EXPECT_TRUE(begins(rows.at(1).at(11), "repeat_failed (solver failed); repeat_poisoned ("));
  for (const auto& row : rows) EXPECT_EQ(row.size(), repeat_table(assessment).header.size());
  EXPECT_TRUE(repeat_table(repeats(1)).rows.empty());
  assessment.definition.impacts.reset();
  EXPECT_TRUE(repeat_table(assessment).rows.empty());
  EXPECT_TRUE(impact_table(assessment).rows.empty());
}

}  // namespace
}  // namespace slosh::impact_tables_test

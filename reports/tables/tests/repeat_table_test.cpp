// Runs that repeat one another: which they are, and their peaks' distribution beside the
// experiment's.
#include <gtest/gtest.h>

#include <limits>

#include "reports/tables/case_tables.hpp"
#include "verification/assessment/across_runs/impact_samples.hpp"
#include "verification/tests/impact_runs.hpp"

namespace slosh::repeat_table_test {
namespace {

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

TEST(RepeatTable, IsLeftOutWithoutRepeatsOrImpacts) {
  EXPECT_FALSE(repeat_table(repeats(1)));
  CaseAssessment assessment = repeats(3);
  assessment.definition.impacts.reset();
  EXPECT_FALSE(repeat_table(assessment));
}

TEST(RepeatTable, GivesTheDistributionBesideTheExperiments) {
  const auto table = repeat_table(repeats(40));
  ASSERT_TRUE(table);
  ASSERT_EQ(table->rows.size(), 8u);
  const auto& experiment = table->rows[0];
  const auto& runs = table->rows[1];
  EXPECT_EQ(experiment.at(0), "experiment");
  EXPECT_EQ(runs.at(0), "repeat_0 to repeat_39");
  EXPECT_EQ(runs.at(3), "40 of 40");
  EXPECT_EQ(experiment.at(4), "3700 ± 400") << "t s / sqrt(40), s = 1112 Pa: 3710 +- 356";
  for (const std::size_t column : {4u, 5u, 6u}) EXPECT_EQ(runs.at(column), experiment.at(column));
  EXPECT_TRUE(runs.at(7).starts_with("1.00 (0.")) << runs.at(7);
  for (const std::size_t column : {8u, 9u, 10u}) EXPECT_EQ(runs.at(column), "1");
}

TEST(RepeatTable, MeasuresHowFarAScaledSampleIsFromTheExperiment) {
  const auto rows = repeat_table(repeats(40, 1.1))->rows;
  EXPECT_TRUE(rows.at(1).at(7).starts_with("1.10 (")) << rows.at(1).at(7);
  EXPECT_EQ(rows.at(1).at(8), "0.16") << "Welch: 371 Pa over 261 Pa, 77 degrees of freedom";
}

TEST(RepeatTable, SaysWhatIsMissing) {
  CaseAssessment assessment = repeats(5);
  assessment.definition.impacts->repeats.clear();
  add_absent_run(assessment, "repeat_failed", repeat(40), RunState::failed);
  TimeSeries poisoned = pressure_of({});
  poisoned.value[2500] = std::numeric_limits<double>::quiet_NaN();
  add_run(assessment, "repeat_poisoned", repeat(41), {poisoned});
  add_run(assessment, "repeat_lame", repeat(42), {pressure_of({.impacts = 1})});
  const auto rows = repeat_table(assessment)->rows;
  EXPECT_EQ(rows.at(0).at(6), "not supplied");
  EXPECT_EQ(rows.at(1).at(3), "6 of 6");
  EXPECT_EQ(rows.at(3).at(3), "5 of 6");
  EXPECT_EQ(rows.at(1).at(6), "fewer than 20 peaks");
  EXPECT_EQ(rows.at(1).at(7), "not supplied");
  EXPECT_TRUE(rows.at(1).at(11).starts_with("repeat_failed (solver failed); repeat_poisoned ("))
      << rows[1][11];
  for (const auto& row : rows) EXPECT_EQ(row.size(), repeat_table(assessment)->header.size());
}

}  // namespace
}  // namespace slosh::repeat_table_test

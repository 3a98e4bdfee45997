// The animation of a case: its runs, its moments, its poster and its history.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numbers>

#include "reports/pages/check_report.hpp"
#include "reports/summary/campaign_report.hpp"
#include "verification/tests/figure_results.hpp"

namespace slosh::case_film_test {
namespace {

using Names = std::vector<std::string>;

CaseDefinition filmed_case() {
  CaseDefinition definition = surge_case();
  definition.animation_times = {1, 1.5, 2};
  return definition;
}

CaseRuns filmed_runs(const Names& names) {
  CaseRuns runs = surge_runs();
  for (const std::string& name : names)
    for (const double time : {1.0, 1.5, 2.0})
      runs.results.at(name).snapshots.push_back(snapshot_at(time, 100));
  return runs;
}

// The last of the case's fields; the test fails where it is no animation.
reports::FieldFigure film_of(const CaseDefinition& definition, const CaseRuns& runs) {
  const auto fields = case_fields(assess(definition, runs));
  if (fields.empty() || !fields.back().film) {
    ADD_FAILURE() << "no animation";
    reports::FieldFigure none;
    none.film.emplace();
    return none;
  }
  return fields.back();
}

void set_elevation(CaseRuns& runs, const std::string& run, double time, double value) {
  for (TimeSeries& series : runs.results.at(run).series)
    if (series.name == surge_quantity)
      for (std::size_t i = 0; i < series.time.size(); ++i)
        if (std::abs(series.time[i] - time) < 0.01) series.value[i] = value;
}

bool says(const reports::FieldFigure& figure, const std::string& sentence) {
  return figure.caption.find(sentence) != std::string::npos;
}

TEST(CaseFilm, IsTheLastFieldAndHasTheFinestRunOfEachSolverAtEachMoment) {
  CaseDefinition definition = filmed_case();
  definition.snapshot_times = {1, 2};
  const CaseRuns runs = filmed_runs({"particles", "coarse_mesh", "fine_mesh"});
  const auto fields = case_fields(assess(definition, runs));
  ASSERT_EQ(fields.size(), 2u);
  EXPECT_FALSE(fields[0].film);
  EXPECT_EQ(fields[0].panels.size(), 4u);  // of the two snapshot times alone
  const reports::FieldFigure& film = fields[1];
  EXPECT_EQ(film.id, "small_surge-animation");
  ASSERT_TRUE(film.film);
  EXPECT_EQ(film.film->names, (Names{"particles", "fine_mesh"}));
  EXPECT_EQ(film.film->labels, (Names{"t = 1.00 s", "t = 1.50 s", "t = 2.00 s"}));
  EXPECT_EQ(film.film->times, (std::vector<double>{1, 1.5, 2}));
  EXPECT_EQ(film.panels.size(), 6u);
  EXPECT_TRUE(says(film, "Animation of 3 moments, 0.5 s apart"));
  const CampaignDefinition campaign{"surges", "Surges", "none", "", {}, "", "surges.toml"};
  EXPECT_NO_THROW(
      reports::check_report(campaign_report(campaign, false, "", {assess(definition, runs)})));
}

TEST(CaseFilm, HasSolversBeyondTwo) {
  CaseDefinition definition = filmed_case();
  CaseRuns runs = filmed_runs({"particles", "fine_mesh"});
  for (const std::string scheme : {"li2010", "delta_sph"}) {
    definition.runs.push_back(sample_run(SphRun{scheme, 0.01, 0.01}));
    definition.runs.back().name = scheme;
    runs.results[scheme] = runs.results.at("particles");
    runs.status[scheme] = {RunState::finished, ""};
  }
  const reports::FieldFigure film = film_of(definition, runs);
  EXPECT_EQ(film.film->names, (Names{"particles", "fine_mesh", "li2010", "delta_sph"}));
  EXPECT_EQ(film.columns, 4);
}

TEST(CaseFilm, TellsTheRollWithTheTime) {
  CaseDefinition definition = filmed_case();
  definition.motion = {{}, RollDefinition{SineMotion{0.1, std::numbers::pi / 2}, 0.45, 0.1}};
  const reports::FieldFigure film = film_of(definition, filmed_runs({"particles"}));
  EXPECT_EQ(film.film->labels.at(0), "t = 1.00 s, roll 5.73°");
  EXPECT_NEAR(film.panels.at(0).angle, 0.1, 1e-12);
}

TEST(CaseFilm, KeepsARunThatLacksMomentsAndTellsSo) {
  CaseRuns runs = filmed_runs({"particles", "fine_mesh"});
  runs.results.at("fine_mesh").snapshots.pop_back();
  const reports::FieldFigure film = film_of(filmed_case(), runs);
  EXPECT_EQ(film.columns, 2);
  EXPECT_TRUE(film.panels.at(5).x.empty());
  EXPECT_TRUE(says(film, " fine_mesh recorded 2 of these moments."));
  EXPECT_FALSE(says(film, "particles recorded"));
}

TEST(CaseFilm, TellsOfASolverThatRecordedNone) {
  const reports::FieldFigure film = film_of(filmed_case(), filmed_runs({"particles"}));
  EXPECT_EQ(film.film->names, (Names{"particles"}));
  EXPECT_TRUE(says(film, " fine_mesh recorded none of them."));
}

TEST(CaseFilm, LeavesOutAMomentThatNoRunRecorded) {
  CaseRuns runs = filmed_runs({"particles", "fine_mesh"});
  for (const std::string run : {"particles", "fine_mesh"})
    runs.results.at(run).snapshots.erase(runs.results.at(run).snapshots.begin());
  EXPECT_EQ(film_of(filmed_case(), runs).film->times, (std::vector<double>{1.5, 2}));
  for (const std::string run : {"particles", "fine_mesh"})
    runs.results.at(run).snapshots.pop_back();
  EXPECT_TRUE(case_fields(assess(filmed_case(), runs)).empty()) << "one moment is no film";
}

TEST(CaseFilmHistory, IsTheElevationOfTheReferencesAndTheFilmsRunsDuringTheFilm) {
  const reports::FieldFigure film =
      film_of(filmed_case(), filmed_runs({"particles", "coarse_mesh", "fine_mesh"}));
  const reports::Figure& history = film.film->history;
  EXPECT_EQ(history.id, "small_surge-animation-history");
  EXPECT_TRUE(history.has_cursor);
  EXPECT_EQ(history.x_range, (std::pair{1.0, 2.0}));
  EXPECT_EQ(labels(history), (Names{"theory", "theory_with_gas", "particles", "fine_mesh"}));
  for (const reports::Curve& curve : history.curves) {
    EXPECT_EQ(curve.x.size(), 51u) << curve.label;
    EXPECT_EQ(curve.y.size(), 51u);
    EXPECT_NEAR(curve.x.front(), 1, 1e-9);
    EXPECT_NEAR(curve.x.back(), 2, 1e-9);
  }
}

TEST(CaseFilmPoster, IsNextToTheHighestElevationOfTheReference) {
  CaseRuns runs = filmed_runs({"particles", "fine_mesh"});
  set_elevation(runs, "theory", 1.6, 0.5);
  set_elevation(runs, "fine_mesh", 2, 0.9);
  const reports::FieldFigure film = film_of(filmed_case(), runs);
  EXPECT_EQ(film.film->poster, 1u);
  EXPECT_TRUE(says(film,
                   "Until it is played it stands at 1.5 s, next to the highest elevation of "
                   "theory."));
}

TEST(CaseFilmPoster, FollowsTheMeshWhereNoReferenceIsInItsRange) {
  CaseRuns runs = filmed_runs({"particles", "fine_mesh"});
  set_elevation(runs, "theory", 1.6, 0.5);
  set_elevation(runs, "fine_mesh", 2, 0.9);
  CaseAssessment assessment = assess(filmed_case(), runs);
  for (const std::string reference : {"theory", "theory_with_gas"})
    assessment.runs.status[reference] = {RunState::out_of_range, "is out of its range"};
  const auto fields = case_fields(assessment);
  ASSERT_EQ(fields.size(), 1u);
  EXPECT_EQ(fields[0].film->poster, 2u);
  EXPECT_TRUE(says(fields[0], "highest elevation of fine_mesh."));
}

TEST(CaseFilmPoster, PrefersAMomentThatAllRunsRecorded) {
  CaseRuns runs = filmed_runs({"particles", "fine_mesh"});
  set_elevation(runs, "theory", 2, 0.5);
  EXPECT_EQ(film_of(filmed_case(), runs).film->poster, 2u);
  runs.results.at("particles").snapshots.pop_back();
  EXPECT_EQ(film_of(filmed_case(), runs).film->poster, 1u);
}

}  // namespace
}  // namespace slosh::case_film_test

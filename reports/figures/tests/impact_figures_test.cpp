// The distributions of impacts' peaks: of repeated runs beside the experiment's repeats, or beside
// the band of a record.
#include <gtest/gtest.h>

#include "reports/figures/case_figures.hpp"
#include "verification/tests/impact_runs.hpp"
#include "verification/tests/messages.hpp"

namespace slosh::impact_figures_test {
namespace {

CaseAssessment repeats(const CaseDefinition& definition, int count) {
  CaseAssessment assessment = no_runs_of(definition);
  for (int i = 0; i < count; ++i) {
    SphRun sph{"recommended", 0.004, 0.004};
    sph.start_disorder = 0.05;
    sph.start_seed = i;
    add_run(assessment, "repeat_" + std::to_string(i), sph,
            {pressure_of({.scale = 0.9 + 0.1 * i})});
  }
  return assessment;
}

TEST(ImpactFigures, DrawTheRepeatsOfEachImpactBesideThoseOfTheExperiment) {
  const auto figures = impact_figures(repeats(impact_case(), 3));
  ASSERT_EQ(figures.size(), 4U);
  EXPECT_EQ(figures[0].id, "impacts-peaks-1");
  const reports::Figure& figure = figures[3];
  EXPECT_EQ(figure.id, "impacts-peaks-4");
  EXPECT_EQ(figure.title, "Distribution of the peaks of impact 4");
  ASSERT_EQ(figure.curves.size(), 2U);
  EXPECT_EQ(figure.curves[0].label, "experiment, 40 peaks");
  EXPECT_EQ(figure.curves[1].label, "repeat_0, 3 peaks");
  const reports::Curve& runs = figure.curves[1];
  ASSERT_EQ(runs.x.size(), 6U);
  EXPECT_NEAR(runs.x.front(), 0.9, 1e-3);
  EXPECT_NEAR(runs.x.back(), 1.1, 1e-3);
  EXPECT_EQ(runs.y.front(), 0);
  EXPECT_EQ(runs.y.back(), 1);
  EXPECT_TRUE(figure.markers.empty());
}

// Put together, an impact that is too high and one that is too low would look like the
// experiment's.
TEST(ImpactFigures, ShowAnImpactThatIsTooHighInItsOwnFigureAlone) {
  CaseDefinition definition = impact_case();
  definition.impacts->peak_means[1] /= 2;
  for (double& peak : definition.impacts->repeats[1]) peak /= 2;
  const auto figures = impact_figures(repeats(definition, 3));
  ASSERT_EQ(figures.size(), 4U);
  EXPECT_NEAR(figures[0].curves[1].x.front(), 0.9, 1e-3);
  EXPECT_NEAR(figures[1].curves[1].x.front(), 1.8, 2e-3);
}

TEST(ImpactFigures, OfASingleImpactMarkTheEdgesOfTheRecordsBand) {
  CaseDefinition definition = impact_case();
  definition.impacts->times = {2.375};
  definition.impacts->peak_means = {3710};
  definition.impacts->repeats.clear();
  CaseAssessment assessment = repeats(definition, 2);
  RecordRun record{"a.csv", impact_pressure, "Pa", {0, 8}, {0, 0}, {}};
  record.has_band = true;
  add_run(assessment, "measured", record,
          {pressure_of({}), pressure_of({.scale = 0.8, .name = impact_pressure + "/lower"}),
           pressure_of({.scale = 1.2, .name = impact_pressure + "/upper"})});
  const auto figures = impact_figures(assessment);
  ASSERT_EQ(figures.size(), 1U);
  ASSERT_EQ(figures[0].curves.size(), 1U);
  ASSERT_EQ(figures[0].markers.size(), 2U);
  EXPECT_NEAR(figures[0].markers[0].x, 0.8, 1e-3);
  EXPECT_NEAR(figures[0].markers[1].x, 1.2, 1e-3);
}

TEST(ImpactFigures, AreOfRepeatsAloneAndTellHowEnoughOfThemCompareWithTheExperiments) {
  EXPECT_TRUE(impact_figures(repeats(impact_case(), 1)).empty());
  CaseAssessment assessment = repeats(impact_case(), 3);
  EXPECT_FALSE(holds(impact_figures(assessment)[0].caption, "Kolmogorov"));
  EXPECT_TRUE(begins(glance_figure(assessment, "repeat_0").value().caption, "pressure"));
  assessment.definition.impacts.reset();
  EXPECT_TRUE(impact_figures(assessment).empty());
  for (const reports::Figure& figure : impact_figures(repeats(impact_case(), 20)))
    EXPECT_TRUE(holds(figure.caption, " repeat_0: 20 peaks, median "));
}

}  // namespace
}  // namespace slosh::impact_figures_test

// One look for each run on every page, and figures of at most six curves.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "reports/figures/case_figures.hpp"
#include "reports/figures/figure_runs.hpp"
#include "verification/case/solver_kinds.hpp"
#include "verification/tests/figure_results.hpp"
#include "verification/tests/messages.hpp"

namespace slosh::run_looks_test {
namespace {

SphRun scheme(const std::string& name, double spacing) { return {name, spacing, spacing}; }

TEST(RunLook, IsOneOfTheFamilysHueInEveryCase) {
  const CaseDefinition one =
      unjudged({{"fine", scheme("recommended", 0.01), 1, {}}, {"mesh", InterFoamRun{9, 9}, 1, {}}})
          .definition;
  const CaseDefinition other = unjudged({{"paper", scheme("li2010", 0.01), 1, {}},
                                         {"finer", scheme("recommended", 0.005), 1, {}}})
                                   .definition;
  EXPECT_EQ(look_of(one, "fine").colour, look_of(other, "finer").colour);
  EXPECT_NE(look_of(one, "fine").colour, look_of(one, "mesh").colour);
  EXPECT_NE(look_of(other, "paper").colour, look_of(other, "finer").colour);
  EXPECT_TRUE(look_of(one, "theory").is_reference);
  EXPECT_FALSE(look_of(one, "mesh").is_reference);
}

TEST(RunLook, DiffersWithinAFamilyInMarkerAndDashTheFinestFirstAndRepeatsAsOne) {
  SphRun changed = scheme("recommended", 0.005);
  changed.numbers.courant_number = 0.4;
  CaseDefinition definition = unjudged({{"coarse", scheme("recommended", 0.02), 1, {}},
                                        {"changed", changed, 1, {}},
                                        {"fine", scheme("recommended", 0.01), 1, {}},
                                        {"fine_2", scheme("recommended", 0.01), 1, {}}})
                                  .definition;
  for (RunDefinition& run : definition.runs)
    if (run.name.starts_with("fine")) run.ensemble = "fine";
  const std::size_t first = look_of(definition, "fine").shape;
  EXPECT_EQ(look_of(definition, "coarse").shape, first + 1);
  EXPECT_EQ(look_of(definition, "changed").shape, first + 2);
  EXPECT_EQ(look_of_family(definition, "recommended"), look_of(definition, "fine"));
}

// The league has more codes than there are hues.
TEST(RunLook, TellsMoreCodesThanHuesApartByTheirMarkers) {
  const auto method = [](const std::string& name) {
    return ExternalRun{{"program"}, {}, {}, {}, {}, name, 0.01};
  };
  InterFoamRun sharp{9, 9};
  sharp.program = FoamProgram::inter_iso_foam;
  const CaseDefinition definition = unjudged({{"recommended", scheme("recommended", 0.01), 1, {}},
                                              {"delta_sph", scheme("delta_sph", 0.01), 1, {}},
                                              {"li2010", scheme("li2010", 0.01), 1, {}},
                                              {"mesh", InterFoamRun{9, 9}, 1, {}},
                                              {"sharp", sharp, 1, {}},
                                              {"theirs", method("pysph_delta_sph"), 1, {}},
                                              {"edac", method("pysph_edac"), 1, {}},
                                              {"walls", method("pysph_adami"), 1, {}},
                                              {"mdbc", method("dualsphysics_mdbc"), 1, {}},
                                              {"one", method("one"), 1, {}},
                                              {"two", method("two"), 1, {}},
                                              {"three", method("three"), 1, {}}})
                                        .definition;
  std::set<std::pair<std::size_t, std::size_t>> looks;
  std::size_t runs = 0;
  for (const RunDefinition& run : definition.runs) {
    if (!is_simulation(run)) continue;
    const reports::Look look = look_of(definition, run.name);
    EXPECT_TRUE(looks.insert({look.colour, look.shape % 10}).second) << run.name;
    ++runs;
  }
  EXPECT_EQ(looks.size(), runs);
  const CaseDefinition few = unjudged({{"one", method("one"), 1, {}},
                                       {"fine", scheme("recommended", 0.01), 1, {}},
                                       {"other", method("other"), 1, {}}})
                                 .definition;
  std::set<std::size_t> hues;
  for (const char* run : {"one", "fine", "other"}) hues.insert(look_of(few, run).colour);
  EXPECT_EQ(hues.size(), 3u) << "few codes have hues of their own";
}

TEST(RunLook, OfAModelIsThatOfItsSchemeAndTellsItsVariantsApart) {
  const std::vector<reports::Look> looks =
      looks_of_models({"interFoam", "recommended", "recommended, antuono"});
  const CaseDefinition definition =
      unjudged({{"fine", scheme("recommended", 0.01), 1, {}}}).definition;
  EXPECT_EQ(looks.at(1), look_of(definition, "fine"));
  EXPECT_EQ(looks.at(2).colour, looks[1].colour);
  EXPECT_NE(looks[2].shape, looks[1].shape);
  EXPECT_NE(looks.at(0).colour, looks[1].colour);
}

// One look in all figures of a case that show the run by its name.
TEST(RunLook, IsTheSameInAllFiguresOfACase) {
  const CaseAssessment assessment =
      assess_scaled({{"fine", scheme("recommended", 0.01), 1.01, {}},
                     {"coarse", scheme("recommended", 0.02), 1.04, {}},
                     {"mesh", InterFoamRun{9, 9}, 1.02, {}}});
  std::map<std::string, std::vector<reports::Look>> looks;
  for (const reports::Figure& figure : case_figures(assessment))
    for (const reports::Curve& curve : figure.curves)
      for (const char* run : {"fine", "mesh"})
        if (curve.label == run || curve.label.starts_with(run + std::string(" ")))
          looks[run].push_back(curve.look.value());
  for (const char* run : {"fine", "mesh"}) {
    ASSERT_GE(looks[run].size(), 4u) << run;
    for (const reports::Look& look : looks[run])
      EXPECT_EQ(look, look_of(assessment.definition, run)) << run;
  }
}

reports::Figure figure_with(std::size_t references, std::size_t runs) {
  reports::Figure figure;
  figure.id = "many";
  figure.title = "Many";
  for (std::size_t i = 0; i < references + runs; ++i) {
    figure.curves.push_back({std::to_string(i), {0, 1}, {0, 1.0 * static_cast<double>(i)}, {}, {}});
    figure.curves.back().look = reports::Look{i < references, i, 0};
  }
  return figure;
}

TEST(FigurePanels, HaveAtMostSixCurvesTheReferencesInEachAndOneScale) {
  for (const auto& [references, runs] :
       {std::pair<std::size_t, std::size_t>{2, 9}, {0, 13}, {1, 6}, {7, 3}}) {
    const reports::Figure whole = figure_with(references, runs);
    const std::vector<reports::Figure> panels = in_panels(whole);
    ASSERT_GT(panels.size(), 1u);
    std::size_t shown = 0;
    std::set<std::string> ids;
    for (const reports::Figure& panel : panels) {
      EXPECT_LE(panel.curves.size(), std::max(most_curves, references + 1));
      EXPECT_GT(panel.curves.size(), references);
      EXPECT_EQ(panel.y_range, panels[0].y_range);
      EXPECT_TRUE(ids.insert(panel.id).second) << panel.id;
      shown += panel.curves.size() - references;
      for (std::size_t i = 0; i < references; ++i)
        EXPECT_EQ(panel.curves[i].label, std::to_string(i));
    }
    EXPECT_EQ(shown, runs);
    EXPECT_EQ(panels[0].id, "many");
  }
  EXPECT_EQ(in_panels(figure_with(2, 4)).size(), 1u);
  EXPECT_EQ(in_panels(figure_with(2, 4))[0].title, "Many");
}

TEST(GlanceFigure, ShowsTheReferenceTheParticlesAndTheFinestMesh) {
  const CaseAssessment assessment = assess(surge_case(), surge_runs());
  const auto figure = glance_figure(assessment);
  ASSERT_TRUE(figure);
  EXPECT_EQ(labels(*figure),
            (std::vector<std::string>{"reference", "SPH recommended", "interFoam (VOF)"}));
  EXPECT_EQ(figure->caption, "elevation of theory, particles, fine_mesh");
  EXPECT_TRUE(figure->is_small);
  EXPECT_EQ(figure->x_range, (std::pair<double, double>{0, 20}));
  const CaseAssessment two = assess_scaled(
      {{"first", scheme("recommended", 0.01), 1, {}}, {"paper", scheme("li2010", 0.01), 1.2, {}}});
  EXPECT_EQ(labels(glance_figure(two).value()).at(1), "SPH recommended");
  EXPECT_EQ(labels(glance_figure(two, "paper").value()).at(1), "SPH li2010") << "which decides";
}

TEST(GlanceFigure, PrefersAReferenceInsideItsRangeAndIsNoneWithoutASeries) {
  CaseRuns runs = surge_runs();
  runs.results.at("theory").diagnostics["highest_elevation_over_depth"] = 0.2;
  const CaseAssessment beyond = assess(surge_case(), runs);
  EXPECT_EQ(glance_figure(beyond).value().caption,
            "elevation of theory_with_gas, particles, fine_mesh");
  runs.results.erase("theory_with_gas");
  runs.status["theory_with_gas"] = {RunState::missing, "not started"};
  const reports::Figure alone = glance_figure(assess(surge_case(), runs)).value();
  EXPECT_EQ(alone.caption, "elevation of theory (out of its range), particles, fine_mesh");
  EXPECT_FALSE(alone.curves.at(0).sets_scale);
  CaseRuns none;
  for (const RunDefinition& run : surge_case().runs)
    none.status[run.name] = {RunState::missing, "not started"};
  EXPECT_FALSE(glance_figure(assess(surge_case(), none)));
}

TEST(HistoryFigure, CutsOffAReferenceOutOfItsRangeAndSaysWhatItReaches) {
  CaseRuns runs = surge_runs();
  RunResult& theory = runs.results.at("theory");
  theory.series[0] = scaled(theory.series[0], 100);
  const auto shown = [&] { return case_figures(assess(surge_case(), runs)).at(0); };
  reports::Figure figure = shown();
  EXPECT_FALSE(holds(figure.caption, "cut off"));
  EXPECT_TRUE(figure.curves.at(0).sets_scale);
  theory.diagnostics["highest_elevation_over_depth"] = 0.2;
  figure = shown();
  EXPECT_FALSE(figure.curves.at(0).sets_scale);
  EXPECT_TRUE(figure.curves.at(2).sets_scale);
  EXPECT_TRUE(holds(figure.caption, "The thin line of theory (out of its range) is cut off"));
}

}  // namespace
}  // namespace slosh::run_looks_test

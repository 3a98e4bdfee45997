// The studies of time step and spacing: which runs stand side by side.
#include <gtest/gtest.h>

#include <optional>

#include "verification/tests/figure_results.hpp"

namespace slosh::study_figures_test {
namespace {

using Names = std::vector<std::string>;

struct StudyRun {
  std::string name, scheme;
  double spacing;
  std::optional<double> courant_number = {}, artificial_viscosity = {};
};

CaseAssessment with_runs(const std::vector<StudyRun>& runs) {
  std::vector<ScaledRun> scaled;
  for (const StudyRun& run : runs) {
    SphRun sph{run.scheme, run.spacing, run.spacing};
    sph.numbers.courant_number = run.courant_number;
    sph.numbers.artificial_viscosity = run.artificial_viscosity;
    scaled.push_back({run.name, sph, 1 + 0.01 * static_cast<double>(scaled.size()), {}});
  }
  return unjudged(scaled);
}

Names studies(const CaseAssessment& assessment) {
  Names names;
  for (const reports::Figure& figure : appendix_figures(assessment))
    if (figure.id.find("-time_step-") != std::string::npos ||
        figure.id.find("-spacing-") != std::string::npos)
      names.push_back(figure.title);
  return names;
}

TEST(StudyFigures, ShowTheSpacingsOfAnExternalProgramsMethod) {
  const auto mine = [](double spacing) {
    return ExternalRun{{"my_sph"}, {}, {}, {}, {}, "my_sph", spacing};
  };
  const CaseAssessment assessment = unjudged({{"fine", mine(0.01), 1.01, {}},
                                              {"coarse", mine(0.02), 1.04, {}},
                                              {"other", ExternalRun{{"other"}}, 1, {}}});
  EXPECT_EQ(studies(assessment), Names{"Particle spacing: my_sph"});
  EXPECT_EQ(labels(figure_of(assessment, "spacing-my_sph")),
            (Names{"20 mm (coarse)", "10 mm (fine)"}));
}

TEST(StudyFigures, AreOfRunsThatDifferInOneThingAlone) {
  const CaseAssessment assessment = with_runs({{"fine", "zhao2021_fixed", 0.002},
                                               {"coarse", "zhao2021_fixed", 0.004},
                                               {"short_steps", "zhao2021_fixed", 0.002, 0.1},
                                               {"long_steps", "zhao2021_fixed", 0.002, 0.4},
                                               {"viscous", "zhao2021_fixed", 0.001, {}, 0.1},
                                               {"moving", "zhao2021_moving", 0.004}});
  EXPECT_EQ(studies(assessment),
            (Names{"Time step: zhao2021_fixed", "Particle spacing: zhao2021_fixed"}));
  const reports::Figure steps = figure_of(assessment, "time_step-zhao2021_fixed");
  EXPECT_EQ(labels(steps),
            (Names{"the scheme's Courant number (fine)", "Courant number 0.4 (long_steps)",
                   "Courant number 0.1 (short_steps)"}));
  const auto elevation = [&](const std::string& run, std::size_t i) {
    return 1000 * assessment.runs.results.at(run).at(surge_quantity).value[i];
  };
  EXPECT_EQ(steps.y_label, "elevation [mm]");
  EXPECT_EQ(steps.curves.at(1).y.at(300), elevation("long_steps", 300));
  const reports::Figure spacings = figure_of(assessment, "spacing-zhao2021_fixed");
  EXPECT_EQ(labels(spacings), (Names{"4 mm (coarse)", "2 mm (fine)"}));
  EXPECT_EQ(spacings.curves.at(0).y.at(300), elevation("coarse", 300));
}

TEST(StudyFigures, OfOneSchemeAreToldApartByWhatTheirRunsShare) {
  const CaseAssessment assessment = with_runs({{"a", "zhao2021_fixed", 0.002},
                                               {"b", "zhao2021_fixed", 0.004},
                                               {"c", "zhao2021_fixed", 0.002, {}, 0.1},
                                               {"d", "zhao2021_fixed", 0.004, {}, 0.1}});
  EXPECT_EQ(studies(assessment),
            (Names{"Particle spacing: zhao2021_fixed",
                   "Particle spacing: zhao2021_fixed, artificial_viscosity = 0.1"}));
  EXPECT_EQ(labels(figure_of(assessment, "spacing-zhao2021_fixed-2")),
            (Names{"4 mm (d)", "2 mm (c)"}));
}

TEST(StudyFigures, ShowTheFilteredPressureWithItsRecord) {
  CaseDefinition definition = gauged_surge();
  definition.runs.push_back(sample_run(SphRun{"recommended", 0.02, 0.02}));
  definition.runs.back().name = "coarse_particles";
  CaseRuns runs = gauged_runs();
  runs.results["coarse_particles"] =
      result_of("coarse_particles", waving("wall_pressure@B", "Pa", 900));
  runs.status["coarse_particles"] = {RunState::finished, ""};
  const CaseAssessment assessment = assess(definition, runs);
  const reports::Figure figure = figure_of(assessment, "spacing-recommended");
  EXPECT_EQ(labels(figure), (Names{"measured", "20 mm (coarse_particles)", "10 mm (particles)"}));
  EXPECT_EQ(figure.y_label, "pressure [Pa]");
  EXPECT_EQ(figure.curves.at(1).y,
            assessment.runs.results.at("coarse_particles").at("wall_pressure@B/filtered").value);
  EXPECT_EQ(figure.curves[0].style, reports::Curve::Style::points);
}

TEST(StudyFigures, NeedTwoRunsThatStand) {
  CaseAssessment assessment = with_runs({{"fine", "li2010", 0.01}, {"coarse", "li2010", 0.02}});
  EXPECT_EQ(studies(assessment), (Names{"Particle spacing: li2010"}));
  assessment.runs.results.erase("coarse");
  assessment.runs.status["coarse"] = {RunState::failed, "diverged"};
  EXPECT_EQ(studies(assessment), Names{});
}

}  // namespace
}  // namespace slosh::study_figures_test

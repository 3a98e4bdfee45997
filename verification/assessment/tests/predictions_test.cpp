#include "verification/assessment/predictions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "reports/summary/report_sections.hpp"
#include "verification/tests/surge_results.hpp"

namespace slosh::predictions_test {
namespace {

// As many cases whose particles are a tenth higher than theory, their meshes right.
std::vector<PredictionSet> sets_of(std::size_t count) {
  static const CaseAssessment higher =
      assess(surge_case(), surge_runs_with("particles", scaled(elevation_of({}), 1.1)));
  return prediction_sets(std::vector<CaseAssessment>(count, higher));
}

const PredictionSet& set_of(const std::vector<PredictionSet>& sets, const std::string& kind,
                            const std::string& model) {
  const auto found = std::find_if(sets.begin(), sets.end(), [&](const PredictionSet& one) {
    return one.kind == kind && one.model == model;
  });
  if (found == sets.end()) throw std::out_of_range(kind + " of " + model);
  return *found;
}

TEST(Predictions, AreOfTheFinestRunOfEachModelAgainstTheTheoryOfItsKind) {
  const auto sets = sets_of(1);
  const PredictionSet& mesh = set_of(sets, "elevation amplitude", "interFoam");
  ASSERT_FALSE(mesh.predictions.empty());
  for (const Prediction& one : mesh.predictions) {
    EXPECT_EQ(one.candidate, "fine_mesh");
    EXPECT_EQ(one.reference, "theory_with_gas");
    EXPECT_EQ(one.value.reference_deviation, 0);
  }
  for (const Prediction& one : set_of(sets, "elevation amplitude", "recommended").predictions) {
    EXPECT_EQ(one.reference, "theory") << "interFoam is a model too, and no reference";
    EXPECT_NEAR(one.value.predicted / one.value.reference, 1.1, 1e-6) << one.mode;
  }
  const PredictionSet& set = set_of(sets, "natural frequency", "recommended");
  EXPECT_EQ(set.unit, "Hz");
  ASSERT_FALSE(set.predictions.empty());
  for (const Prediction& one : set.predictions) {
    EXPECT_NE(one.mode, "forced");
    EXPECT_NEAR(one.value.predicted / one.value.reference, 1, 1e-6);
  }
}

TEST(Predictions, OfModesBelowATenthOfTheLargestDoNotCountAsAmplitudes) {
  CaseAssessment assessment = assess(surge_case(), surge_runs());
  const auto modes = [&](double share) {
    for (Comparison& pair : assessment.comparisons)
      for (ModeComparison& mode : pair.modes)
        if (mode.mode != "forced")
          mode.reference.amplitude.value = share * pair.modes.at(0).reference.amplitude.value;
    return set_of(prediction_sets({assessment}), "elevation amplitude", "recommended")
        .predictions.size();
  };
  ASSERT_EQ(assessment.comparisons.at(0).modes.at(0).mode, "forced");
  EXPECT_EQ(modes(0.09), 1u);
  EXPECT_GT(modes(0.11), 1u);
}

TEST(Predictions, AgainstAReferenceOutOfItsRangeDoNotCount) {
  CaseRuns runs = surge_runs();
  runs.results.at("theory").diagnostics["highest_elevation_over_depth"] = 0.2;
  for (const PredictionSet& set : prediction_sets({assess(surge_case(), runs)}))
    EXPECT_NE(set.model, "recommended");
}

TEST(BiasSection, StatesTheFactorThatAllCasesWereMadeWith) {
  const auto sets = sets_of(5);
  const auto& bias = set_of(sets, "elevation amplitude", "recommended").bias;
  ASSERT_TRUE(bias);
  EXPECT_NEAR(bias->bias, 1.1, 1e-6);
  EXPECT_LT(bias->relative_deviation, 1e-6);
  const reports::Section section = bias_section(sets);
  ASSERT_EQ(section.tables.size(), 1u);
  EXPECT_EQ(section.tables[0].rows[0][3], "1.1000");
  ASSERT_FALSE(section.figures.empty());
  EXPECT_EQ(section.figures[0].id, "bias-elevation-amplitude-ratio");
  const reports::Figure& ratios = section.figures[0];
  ASSERT_EQ(ratios.curves.size(), 5u);  // agreement, and the band and the points of two models
  EXPECT_EQ(ratios.curves[0].y, (std::vector<double>{1, 1}));
  EXPECT_EQ(ratios.x_ticks.at(0).second,
            "n = " + std::to_string(
                         set_of(sets, "elevation amplitude", "recommended").predictions.size()));
  const reports::Curve &band = ratios.curves[1], &points = ratios.curves[2];
  EXPECT_EQ(points.label, "recommended");
  EXPECT_EQ(points.look, band.look);
  EXPECT_NE(points.look, ratios.curves[4].look);
  EXPECT_EQ(points.y.size(), points.y_error.size());
  for (const double ratio : points.y) EXPECT_NEAR(ratio, 1.1, 1e-6);
  for (const double x : points.x) EXPECT_NEAR(x, 0, 0.5) << "beside the model's column";
  EXPECT_NEAR(band.lower.at(0), 1.1, 1e-5);
  EXPECT_NEAR(band.upper.at(0), 1.1, 1e-5);
}

TEST(BiasSection, HasBarsAsLongAsTheIntervalOfTheRatioAndAtMostFiveModelsInAFigure) {
  auto sets = sets_of(5);
  PredictionSet& set = sets.front();
  set.predictions[0].ratio_half_width = 0.2;
  set.predictions[1].ratio_half_width = std::numeric_limits<double>::quiet_NaN();
  const reports::Section section = bias_section(sets);
  EXPECT_EQ(section.figures.at(0).curves.at(2).y_error.at(0), 0.2);
  EXPECT_EQ(section.figures[0].curves[2].y_error.at(1), 0) << "gnuplot would leave the point out";
  std::vector<PredictionSet> many(7, set);
  for (std::size_t i = 0; i < 7; ++i) many[i].model = "model " + std::to_string(i);
  const std::vector<reports::Figure> figures = bias_section(many).figures;
  ASSERT_EQ(figures.size(), 2u);
  EXPECT_EQ(figures[1].x_ticks.size(), 2u);
  EXPECT_EQ(figures[1].id, "bias-elevation-amplitude-ratio-2");
}

TEST(BiasSection, SaysWhereThereAreTooFewComparisons) {
  const auto sets = sets_of(1);
  const reports::Section section = bias_section(sets);
  EXPECT_TRUE(section.tables.empty());
  EXPECT_TRUE(section.figures.empty());
  EXPECT_NE(section.paragraphs.at(1).find("Too few comparisons, fewer than 5"), std::string::npos);
  EXPECT_NE(section.paragraphs[1].find("elevation amplitude of recommended ("), std::string::npos);
  EXPECT_NE(bias_section({}).paragraphs.at(1).find("No case"), std::string::npos);
}

}  // namespace
}  // namespace slosh::predictions_test

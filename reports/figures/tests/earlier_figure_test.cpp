#include "reports/figures/earlier_figure.hpp"

#include <gtest/gtest.h>

#include "reports/figures/run_looks.hpp"
#include "verification/tests/figure_results.hpp"

namespace slosh::earlier_figure_test {
namespace {

using Names = std::vector<std::string>;

GateRow row_on_pressure() {
  GateRow row{};
  row.candidate = "particles";
  row.reference = "theory";
  row.quantity = "wall_pressure@B";
  row.mode = "whole";
  row.metric = Metric::normalised_rms;
  return row;
}

EarlierResult earlier_pressure(bool row_held) {
  return {result_of("particles", waving("wall_pressure@B", "Pa", 900)), "2026-01-02", row_held};
}

TEST(EarlierFigure, ShowsTheReferenceTheEarlierResultAndThePresentOne) {
  const CaseAssessment assessment = assess(gauged_surge(), gauged_runs());
  const reports::Figure figure =
      earlier_figure(assessment, row_on_pressure(), earlier_pressure(true));
  EXPECT_EQ(figure.id, "small_surge-earlier-particles-wall_pressure-B");
  EXPECT_EQ(labels(figure), (Names{"theory", "particles on 2026-01-02", "particles now"}));
  EXPECT_EQ(figure.curves.at(1).y, waving("", "", 900).value);
  EXPECT_EQ(figure.curves.at(2).y, waving("", "", 1010).value);
  EXPECT_EQ(figure.curves[1].style, reports::Curve::Style::dashed);
  EXPECT_EQ(figure.curves[2].look, look_of(assessment.definition, "particles"));
}

TEST(EarlierFigure, SaysWhetherTheRowHeld) {
  const CaseAssessment assessment = assess(gauged_surge(), gauged_runs());
  const auto caption = [&](bool held) {
    return earlier_figure(assessment, row_on_pressure(), earlier_pressure(held)).caption;
  };
  EXPECT_NE(caption(true).find("With the result of 2026-01-02 it held."), std::string::npos);
  EXPECT_NE(caption(false).find("it did not hold either."), std::string::npos);
}

TEST(EarlierFigure, RefusesAnEarlierResultWithoutTheSeries) {
  const CaseAssessment assessment = assess(gauged_surge(), gauged_runs());
  EarlierResult earlier = earlier_pressure(true);
  earlier.result.series.clear();
  EXPECT_THROW(earlier_figure(assessment, row_on_pressure(), earlier), ResultError);
}

}  // namespace
}  // namespace slosh::earlier_figure_test

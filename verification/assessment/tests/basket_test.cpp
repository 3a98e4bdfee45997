// The choices of a basket: which runs they are, and their ratios, on synthetic results.
#include "verification/assessment/across_runs/basket.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "verification/tests/surge_results.hpp"

namespace slosh::basket_test {
namespace {

BasketMeasure measure_of(const std::string& case_name, double goal) {
  GateRow row = surge_row("whole", Metric::normalised_rms, "1", goal);
  row.candidate = "";
  return {case_name, case_name, row};
}

// A goal of 1 % in one case and of 4 % in the other.
const std::vector<BasketMeasure> measures{measure_of("deep", 0.01), measure_of("shallow", 0.04)};

ScaledRun scaled_run(const std::string& name, double scale, double core_seconds = 1) {
  return {name,
          SphRun{"recommended", 0.01, 0.01},
          scale,
          {.user_time = 0.75 * core_seconds, .system_time = 0.25 * core_seconds}};
}

CaseAssessment surge_named(const std::string& name, const std::vector<ScaledRun>& runs) {
  CaseAssessment assessment = assess_scaled(runs);
  assessment.definition.name = name;
  return assessment;
}

std::vector<std::string> names_of(const BasketAssessment& basket) {
  std::vector<std::string> names;
  for (const BasketChoice& one : basket.choices) names.push_back(one.name);
  return names;
}

TEST(Basket, JudgesAChoiceByItsWorstAndItsMeanRatioOverAllCases) {
  const BasketAssessment basket =
      assess(measures, {surge_named("deep", {scaled_run("a", 1.02, 3), scaled_run("b", 1.01)}),
                        surge_named("shallow", {scaled_run("a", 1.02, 5), scaled_run("b", 1.12)})});
  ASSERT_EQ(names_of(basket), (std::vector<std::string>{"a", "b"}));
  const BasketChoice& a = basket.choices[0];
  EXPECT_NEAR(a.values.at(0).value.value, 0.02, 1e-6);
  EXPECT_NEAR(a.values[0].ratio, 2, 1e-4);
  EXPECT_NEAR(a.values.at(1).ratio, 0.5, 1e-4);
  EXPECT_NEAR(a.worst, 2, 1e-4);
  EXPECT_NEAR(a.mean, 1.25, 1e-4);
  EXPECT_NEAR(a.core_seconds, 8, 1e-12);
  const BasketChoice& b = basket.choices[1];
  EXPECT_NEAR(b.worst, 3, 1e-4) << "it is better in the deep case alone";
  EXPECT_NEAR(b.mean, 2, 1e-4);
}

TEST(Basket, HasARatioInProportionToTheErrorOfEitherSign) {
  const auto ratio = [](double scale) {
    const BasketAssessment basket =
        assess(measures, {surge_named("deep", {scaled_run("a", scale)}),
                          surge_named("shallow", {scaled_run("a", 1)})});
    return basket.choices.at(0).worst;
  };
  EXPECT_NEAR(ratio(1.03), 3, 1e-4);
  EXPECT_NEAR(ratio(1.06), 2 * ratio(1.03), 1e-4);
  EXPECT_NEAR(ratio(0.97), ratio(1.03), 1e-4);
  EXPECT_NEAR(ratio(1), 0, 1e-9);
}

TEST(Basket, TakesTheValueAndTheIntervalOfAGateRow) {
  std::vector<BasketMeasure> amplitudes = measures;
  for (BasketMeasure& one : amplitudes)
    one.row.metric = Metric::amplitude_error, one.row.mode = "forced";
  CaseAssessment deep = surge_named("deep", {scaled_run("a", 0.98)});
  const BasketAssessment basket =
      assess(amplitudes, {deep, surge_named("shallow", {scaled_run("a", 1)})});
  GateRow row = amplitudes[0].row;
  row.candidate = "a";
  const GateOutcome gated = CaseEvidence(deep.definition, deep.runs).judge(row);
  const BasketValue& value = basket.choices.at(0).values.at(0);
  EXPECT_EQ(value.value.value, gated.value.value);
  EXPECT_EQ(value.value.half_width, gated.judgement.value().uncertainty);
  EXPECT_NEAR(value.value.value, -0.02, 1e-6);
  EXPECT_NEAR(value.ratio, 2, 1e-4);
}

TEST(Basket, PutsAChoiceWithUnusableDataLastAndSaysWhy) {
  CaseAssessment deep = surge_named("deep", {scaled_run("broken", 1), scaled_run("poor", 2)});
  deep.runs.results.at("broken").series.at(0).value[500] = std::numeric_limits<double>::quiet_NaN();
  deep.fitted = {};
  const BasketAssessment basket = assess(
      measures, {deep, surge_named("shallow", {scaled_run("broken", 1), scaled_run("poor", 2)})});
  ASSERT_EQ(names_of(basket), (std::vector<std::string>{"poor", "broken"}));
  const BasketChoice& broken = basket.choices[1];
  EXPECT_EQ(missing_values(broken), 1u);
  EXPECT_TRUE(std::isnan(broken.worst));
  EXPECT_TRUE(std::isnan(broken.mean));
  EXPECT_TRUE(std::isnan(broken.values.at(0).ratio));
  EXPECT_NE(broken.values[0].message, "");
  EXPECT_NEAR(broken.values.at(1).ratio, 0, 1e-9);
  EXPECT_EQ(broken.values[1].message, "");
}

TEST(Basket, PutsAChoiceWhoseRunFailedLastAndHasNoProcessorTimeOfIt) {
  CaseAssessment deep = surge_named("deep", {scaled_run("failed", 1), scaled_run("poor", 2)});
  deep.runs.results.erase("failed");
  deep.runs.status.at("failed") = {RunState::failed, "diverged"};
  deep.fitted = {};
  const BasketAssessment basket = assess(
      measures, {deep, surge_named("shallow", {scaled_run("failed", 1), scaled_run("poor", 2)})});
  ASSERT_EQ(names_of(basket), (std::vector<std::string>{"poor", "failed"}));
  EXPECT_EQ(basket.choices[1].values.at(0).message, "the candidate failed failed: diverged");
  EXPECT_TRUE(std::isnan(basket.choices[1].core_seconds));
  EXPECT_EQ(basket.choices[0].core_seconds, 2);
}

TEST(Basket, NamesTheCaseThatDoesNotHaveTheRun) {
  const std::vector<ScaledRun> runs{scaled_run("a", 1)};
  std::vector<BasketMeasure> three = measures;
  three.push_back(measure_of("tall", 0.01));
  const BasketAssessment basket =
      assess(three, {surge_named("deep", runs), surge_named("shallow", runs),
                     surge_named("tall", {scaled_run("b", 1)})});
  ASSERT_EQ(names_of(basket), (std::vector<std::string>{"a"})) << "b stands in one case alone";
  EXPECT_EQ(basket.choices[0].values.at(2).message, "tall has no run a");
  EXPECT_EQ(missing_values(basket.choices[0]), 1u);
}

TEST(Basket, ComparesNoReferenceAndNoRunThatIsNotSelected) {
  const std::vector<ScaledRun> runs{scaled_run("a", 1), scaled_run("fine", 1)};
  std::vector<BasketMeasure> against_fine = measures;
  against_fine[1].row.reference = "fine";
  CaseAssessment deep = surge_named("deep", runs), shallow = surge_named("shallow", runs);
  EXPECT_EQ(names_of(assess(measures, {deep, shallow})), (std::vector<std::string>{"a", "fine"}));
  EXPECT_EQ(names_of(assess(against_fine, {deep, shallow})), (std::vector<std::string>{"a"}));
  shallow.runs.status.at("a") = {RunState::not_selected, ""};
  EXPECT_EQ(names_of(assess(measures, {deep, shallow})), (std::vector<std::string>{"fine"}));
}

TEST(Basket, MeasuresTheRunWithTheSuffixForItsChoice) {
  std::vector<BasketMeasure> three = measures;
  three.push_back(measure_of("deep", 0.1));
  three[2].run_suffix = "_disordered";
  const BasketAssessment basket =
      assess(three, {surge_named("deep", {scaled_run("a", 1), scaled_run("a_disordered", 1.05)}),
                     surge_named("shallow", {scaled_run("a", 1), scaled_run("a_disordered", 1)})});
  ASSERT_EQ(names_of(basket), (std::vector<std::string>{"a"}));
  EXPECT_NEAR(basket.choices[0].values.at(2).ratio, 0.5, 1e-4);
  EXPECT_NEAR(basket.choices[0].worst, 0.5, 1e-4);
}

TEST(Basket, TakesTheMeanOverAnEnsembleWithTheIntervalOfItsScatter) {
  std::vector<BasketMeasure> three = measures;
  three.push_back(measure_of("deep", 0.1));
  three[2].run_suffix = "_disordered";
  CaseAssessment deep =
      surge_named("deep", {scaled_run("a", 1), scaled_run("a_disordered", 1.04),
                           scaled_run("a_disordered_2", 1.05), scaled_run("a_disordered_3", 1.06)});
  for (RunDefinition& run : deep.definition.runs)
    if (run.name.starts_with("a_disordered")) run.ensemble = "a_disordered";
  const BasketAssessment basket =
      assess(three, {deep, surge_named("shallow", {scaled_run("a", 1)})});
  ASSERT_EQ(names_of(basket), (std::vector<std::string>{"a"})) << "a later member is no choice";
  const BasketValue& disordered = basket.choices[0].values.at(2);
  EXPECT_NEAR(disordered.value.value, 0.05, 1e-5);
  // Student's factor of two degrees of freedom, for a standard deviation of 0.01.
  EXPECT_NEAR(disordered.value.half_width, 4.30265 * 0.01 / std::sqrt(3.0), 1e-4);
  EXPECT_NEAR(disordered.ratio, 0.5, 1e-4);
}

TEST(Basket, CountsOnlyItsOwnCases) {
  const std::vector<ScaledRun> runs{scaled_run("a", 1)};
  const std::vector<CaseAssessment> cases{surge_named("deep", runs), surge_named("other", runs)};
  EXPECT_TRUE(assess(measures, cases).choices.empty());
}

}  // namespace
}  // namespace slosh::basket_test

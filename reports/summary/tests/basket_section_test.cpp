// The basket of a campaign in its report and in results.json.
#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "reports/pages/check_report.hpp"
#include "reports/summary/campaign_report.hpp"
#include "reports/summary/report_sections.hpp"
#include "verification/tests/surge_results.hpp"

namespace slosh::basket_section_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

BasketMeasure measure_of(const std::string& case_name, const std::string& title, double goal) {
  GateRow row = surge_row("whole", Metric::normalised_rms, "1", goal);
  row.candidate = "";
  return {case_name, title, row};
}

const std::vector<BasketMeasure> measures{measure_of("deep", "deep tank", 0.01),
                                          measure_of("shallow", "shallow", 0.04)};

BasketValue value_of(double value, double goal) { return {{value, 0}, value / goal, ""}; }

BasketAssessment two_choices() {
  return {measures,
          {{"fast", {value_of(0.0048, 0.01), value_of(0.05, 0.04)}, 1.25, 0.865, 8},
           {"broken", {{{nan, nan}, nan, "the series is NaN"}, value_of(0, 0.04)}, nan, nan, nan}}};
}

TEST(BasketSection, HasALineForEachChoiceWithItsValuesAndRatios) {
  const reports::Section section = basket_section(two_choices());
  EXPECT_EQ(section.title, "Basket");
  ASSERT_EQ(section.tables.size(), 1u);
  const reports::Table& table = section.tables[0];
  EXPECT_EQ(table.header,
            (std::vector<std::string>{"choice", "deep tank", "shallow", "worst ratio", "mean ratio",
                                      "processor time [core-seconds]"}));
  EXPECT_EQ(table.rows.at(0),
            (std::vector<std::string>{"fast", "0.48 %, 0.48 of the goal", "5 %, 1.2 of the goal",
                                      "1.2", "0.86", "8"}));
  EXPECT_NE(table.caption.find("|value| / goal"), std::string::npos);
  EXPECT_NE(table.caption.find("A goal is no gate and decides no verdict."), std::string::npos);
}

TEST(BasketSection, ShowsTheHalfWidthOfAValueThatHasOne) {
  BasketAssessment basket = two_choices();
  basket.choices[0].values[0].value.half_width = 0.001;
  EXPECT_EQ(basket_section(basket).tables.at(0).rows.at(0).at(1),
            "0.48 ± 0.10 %, 0.48 of the goal");
}

TEST(BasketSection, TellsThatAValueIsMissingAndWhy) {
  const reports::Section section = basket_section(two_choices());
  EXPECT_EQ(section.tables.at(0).rows.at(1),
            (std::vector<std::string>{"broken", "not available", "0 %, 0 of the goal",
                                      "not available: 1 of 2 values missing",
                                      "not available: 1 of 2 values missing", "not available"}));
  EXPECT_EQ(section.paragraphs.back(),
            "The value of broken in the column deep tank is not available: the series is NaN.");
}

TEST(BasketSection, StatesEachMeasureWithItsGoal) {
  EXPECT_EQ(basket_section(two_choices()).paragraphs.at(0),
            "The basket has these measures. deep tank (deep): normalised_rms of elevation@right "
            "against theory, whole, goal 1 %. shallow: normalised_rms of elevation@right against "
            "theory, whole, goal 4 %.");
}

TEST(BasketSection, SaysSoWhereNoRunStandsInTwoCases) {
  const reports::Section section = basket_section({measures, {}});
  EXPECT_TRUE(section.tables.empty());
  EXPECT_EQ(section.paragraphs.back(), "No run stands in two or more of the basket's cases.");
}

CaseAssessment surge_named(const std::string& name, double scale) {
  CaseAssessment assessment =
      assess_scaled({{"particles", SphRun{"recommended", 0.01, 0.01}, scale, {.user_time = 2}}});
  assessment.definition.name = name;
  return assessment;
}

TEST(BasketSection, StandsOnThePageAcrossTheCasesAndDecidesNoVerdict) {
  CampaignDefinition campaign;
  campaign.name = campaign.title = campaign.source = "surges";
  const std::vector<CaseAssessment> cases{surge_named("deep", 1.5), surge_named("shallow", 1.02)};
  const reports::Report without = campaign_report(campaign, false, "./slosh", cases);
  campaign.basket = measures;
  const reports::Report report = campaign_report(campaign, false, "./slosh", cases);
  EXPECT_NO_THROW(reports::check_report(report));
  EXPECT_EQ(report.pages.back().id, "across");
  EXPECT_EQ(report.sections.back().id, "basket");
  EXPECT_EQ(report.sections.back().page, "across");
  EXPECT_EQ(report.sections.back().tables.at(0).rows.at(0).at(3), "50");
  const std::vector<reports::Figure>& costs = report.sections.back().figures;
  ASSERT_EQ(costs.size(), 2u) << "the error against the run time in each case";
  EXPECT_EQ(costs[0].id, "deep-cost-side-by-side");
  EXPECT_EQ(costs[1].id, "shallow-cost-side-by-side");
  EXPECT_TRUE(costs[0].title.starts_with("Error against run time: ")) << costs[0].title;
  EXPECT_EQ(report.verdict, without.verdict);
  EXPECT_EQ(report.outcome, without.outcome);
  EXPECT_EQ(without.pages.size() + 1, report.pages.size());

  const auto document = nlohmann::json::parse(report.results_json);
  EXPECT_EQ(document.at("basket").at("measures").at(1).at("goal"), 0.04);
  const nlohmann::json& choice = document.at("basket").at("choices").at(0);
  EXPECT_EQ(choice.at("choice"), "particles");
  EXPECT_NEAR(choice.at("values").at(0).at("value"), 0.5, 1e-4);
  EXPECT_NEAR(choice.at("worst_ratio"), 50, 1e-2);
  EXPECT_NEAR(choice.at("mean_ratio"), 25.25, 1e-2);
  EXPECT_EQ(choice.at("core_seconds_s"), 4);
  EXPECT_FALSE(nlohmann::json::parse(without.results_json).contains("basket"));
}

}  // namespace
}  // namespace slosh::basket_section_test

// Several campaigns on one page, read from the results that their reports hold.
#include "reports/summary/recorded_campaigns.hpp"

#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "reports/pages/write_report.hpp"
#include "reports/summary/results_json.hpp"
#include "verification/tests/messages.hpp"
#include "verification/tests/surge_results.hpp"

namespace slosh::recorded_campaigns_test {
namespace {

// Five cases whose particles are higher than theory by the factor.
std::string results_of(const std::string& campaign, bool quick, double factor) {
  static std::map<double, CaseAssessment> judged;
  if (!judged.contains(factor))
    judged.emplace(factor, assess(surge_case(),
                                  surge_runs_with("particles", scaled(elevation_of({}), factor))));
  CaseAssessment one = judged.at(factor);
  std::vector<CaseAssessment> cases;
  for (int i = 0; i < 5; ++i) {
    one.definition.name = "case_" + std::to_string(i);
    cases.push_back(one);
  }
  return results_json(campaign, quick, cases);
}

const PredictionSet& particles(const std::vector<PredictionSet>& sets) {
  for (const PredictionSet& one : sets)
    if (one.kind == "elevation amplitude" && one.model == "recommended") return one;
  throw std::out_of_range("no set");
}

TEST(RecordedCampaign, HasTheVerdictsAndThePredictionsOfItsResults) {
  const RecordedCampaign campaign =
      recorded_campaign(results_of("surges", true, 1.02), "surges/report/index.html");
  EXPECT_EQ(campaign.name, "surges");
  EXPECT_TRUE(campaign.is_quick);
  EXPECT_EQ(campaign.exit_status, 0);
  EXPECT_EQ(campaign.rows, 15u);
  EXPECT_EQ(campaign.passed, 15u);
  for (const Prediction& one : particles(campaign.predictions).predictions) {
    EXPECT_NEAR(one.value.predicted / one.value.reference, 1.02, 1e-6);
    EXPECT_GE(one.ratio_half_width, 0);
  }
}

TEST(RecordedCampaign, IsRefusedWhereTheTextIsOfSomethingElse) {
  for (const std::string text : {"", "{}", "[1]", "{\"campaign\": 3}"})
    EXPECT_THROW(recorded_campaign(text, "x"), std::invalid_argument) << text;
  nlohmann::json odd = nlohmann::json::parse(results_of("surges", false, 1.02));
  odd["exit_status"] = 77;
  EXPECT_THROW(recorded_campaign(odd.dump(), "x"), std::invalid_argument);
  odd["exit_status"] = 0;
  EXPECT_NO_THROW(recorded_campaign(odd.dump(), "x"));
  nlohmann::json forged = odd;
  for (const char* verdict : {"violated", "solver failed", "good"}) {
    forged["cases"][0]["gate"][0]["verdict"] = verdict;
    EXPECT_THROW(recorded_campaign(forged.dump(), "x"), std::invalid_argument) << verdict;
  }
  forged["cases"][0]["gate"][0]["verdict"] = "inconclusive";
  for (const int asked : {0, 5, 77}) {
    forged["exit_status"] = asked;
    EXPECT_EQ(recorded_campaign(forged.dump(), "x").exit_status, 5) << "--inconclusive-exit";
  }
  odd["model_bias"][0]["comparisons"][0].erase("predicted");
  EXPECT_THROW(recorded_campaign(odd.dump(), "x"), std::invalid_argument);
}

TEST(RecordedCampaigns, CountAComparisonOnceThatOfTheWholeCampaignFirstAndEachReference) {
  const RecordedCampaign quick = recorded_campaign(results_of("surges", true, 1.2), "a");
  RecordedCampaign whole = recorded_campaign(results_of("surges", false, 1.02), "b");
  const PredictionSet merged = particles(merged_predictions({quick, whole}));
  const std::size_t before = particles(whole.predictions).predictions.size();
  EXPECT_EQ(merged.predictions.size(), before);
  ASSERT_TRUE(merged.bias);
  EXPECT_NEAR(merged.bias->bias, 1.02, 1e-6);
  for (PredictionSet& set : whole.predictions)
    if (set.kind == "elevation amplitude" && set.model == "recommended") {
      set.predictions.push_back(set.predictions.front());
      set.predictions.back().reference = "another";
    }
  EXPECT_EQ(particles(merged_predictions({whole})).predictions.size(), before + 1);
  EXPECT_EQ(particles(merged_predictions({whole, whole})).predictions.size(), before + 1);
}

TEST(RecordedCampaigns, StandOnOnePageWithTheBandOfEachModel) {
  const std::vector<RecordedCampaign> campaigns{
      recorded_campaign(results_of("surges", false, 1.02), "surges/report/index.html"),
      recorded_campaign(results_of("others", false, 1.2), "others/report/index.html")};
  const reports::Report report = report_of_campaigns(campaigns, {"bad/results.json: no JSON"});
  EXPECT_NO_THROW(reports::check_report(report));
  EXPECT_EQ(report.verdict, "1 of 3 campaigns pass; 25 of 30 gate rows hold.");
  EXPECT_EQ(report.outcome, reports::Outcome::fail);
  ASSERT_EQ(report.sections.size(), 2u);
  EXPECT_EQ(report.sections[0].figures.at(0).id, "bias-elevation-amplitude-ratio");
  const reports::Table& table = report.sections[1].tables.at(0);
  EXPECT_EQ(table.rows.at(1).at(0), "violated");
  EXPECT_EQ(table.rows.at(1).at(1), "others");
  EXPECT_TRUE(holds(report.sections[1].paragraphs.at(0), "bad/results.json: no JSON"));
  EXPECT_EQ(nlohmann::json::parse(report.results_json).at("exit_status"), 1);
}

TEST(RecordedCampaigns, HaveTheWorstExitStatusOfAll) {
  const struct {
    std::vector<int> statuses;
    int worst;
    std::vector<std::string> unread = {};
  } all[] = {{{0, 5, 0}, 5},
             {{5, 4}, 4},
             {{4, 1, 0}, 1},
             {{1, 3}, 3},
             {{0}, 0},
             {{}, 4},
             {{0}, 4, {"no such file"}},
             {{1}, 1, {"no such file"}}};
  for (const auto& [statuses, worst, unread] : all) {
    std::vector<RecordedCampaign> campaigns;
    for (const int status : statuses) campaigns.push_back({"a", false, status, 0, 0, "", {}});
    EXPECT_EQ(exit_status(campaigns, unread), worst);
  }
}

}  // namespace
}  // namespace slosh::recorded_campaigns_test

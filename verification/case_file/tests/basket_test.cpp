// [[basket]]: what is read, and what is refused with which message.
#include <gtest/gtest.h>

#include <fstream>

#include "verification/case_file/campaign_parser.hpp"
#include "verification/case_file/case_parser.hpp"
#include "verification/case_file/sweep.hpp"
#include "verification/tests/small_campaign.hpp"
#include "verification/tests/temporary_directory.hpp"

namespace slosh::basket_test {
namespace {

const std::string head =
    "schema_version = 1\nname = \"choices\"\ntitle = \"t\"\nsource = \"s\"\ncases = "
    "[\"./small.toml\", \"./other.toml\"]\n";
const std::string wave = R"([[basket]]
case = "small"
title = "small wave"
reference = "theory"
quantity = "elevation@right"
metric = "normalised_rms"
mode = "whole"
goal = 0.01
)";
const std::string height = R"([[basket]]
case = "other"
quantity = "elevation@right"
metric = "largest_magnitude"
mode = "whole"
goal = 0.02
)";

class Basket : public ::testing::Test {
 protected:
  Basket() {
    std::ofstream(directory.path() / "small.toml") << particles_case;
    std::ofstream(directory.path() / "other.toml")
        << with(particles_case, "name = \"small\"", "name = \"other\"");
  }

  std::vector<BasketMeasure> read(const std::string& text) const {
    const auto file = directory.path() / "choices.toml";
    std::ofstream(file) << head << text;
    const CampaignDefinition campaign = read_campaign(file, directory.path(), {});
    std::vector<CaseDefinition> cases;
    for (const auto& one : campaign.cases) {
      cases.push_back(read_case(one));
      add_swept_runs(campaign, "", cases.back());
    }
    return read_basket(campaign, cases);
  }

  // The message without the directory; "" where nothing is wrong.
  std::string refusal(const std::string& text) const {
    try {
      read(text);
      return "";
    } catch (const CaseFileError& error) {
      return std::string(error.what()).substr(directory.path().string().size() + 1);
    }
  }

  void expect_refusal(const std::string& text, const std::string& beginning) const {
    const std::string message = refusal(text);
    EXPECT_TRUE(message.starts_with(beginning))
        << "got:    " << message << "\nwanted: " << beginning;
  }

  TemporaryDirectory directory;
};

TEST_F(Basket, HasAMeasureForEachTableWithTheUnitOfItsMetric) {
  const std::vector<BasketMeasure> basket = read(wave + height);
  ASSERT_EQ(basket.size(), 2u);
  EXPECT_EQ(basket[0].case_name, "small");
  EXPECT_EQ(basket[0].title, "small wave");
  EXPECT_EQ(basket[0].row.candidate, "");
  EXPECT_EQ(basket[0].row.reference, "theory");
  EXPECT_EQ(basket[0].row.quantity, "elevation@right");
  EXPECT_EQ(basket[0].row.metric, Metric::normalised_rms);
  EXPECT_EQ(basket[0].row.unit, "1");
  EXPECT_EQ(basket[0].row.mode, "whole");
  EXPECT_EQ(basket[0].row.limit, 0.01);
  EXPECT_EQ(basket[0].row.where.line, 6);
  EXPECT_EQ(basket[1].title, "other") << "a measure without a title is called after its case";
  EXPECT_EQ(basket[1].row.reference, "");
  EXPECT_EQ(basket[1].row.unit, "m");
}

TEST_F(Basket, IsEmptyWhereTheCampaignDeclaresNone) { EXPECT_TRUE(read("").empty()); }

TEST_F(Basket, TakesASweptRunAsReference) {
  const std::string sweep =
      "[[sweep]]\ncases = [\"small\"]\nname = \"fine\"\nsolver = \"sph\"\nscheme = "
      "\"recommended\"\nparticle_spacing_m = 0.025\n";
  EXPECT_EQ(read(sweep + with(wave, "\"theory\"", "\"fine\"") + height).at(0).row.reference,
            "fine");
}

TEST_F(Basket, RefusesEachKindOfMistakeWithItsPlace) {
  expect_refusal(with(wave, "\"small\"", "\"smal\"") + height,
                 "choices.toml:7: basket.case = \"smal\": expected a case of the campaign, one of "
                 "small, other; nearest: small");
  expect_refusal(with(wave, "normalised_rms", "normalized_rms") + height,
                 "choices.toml:11: basket.metric = \"normalized_rms\": expected a metric of one "
                 "run that is best at zero, one of amplitude_error, ");
  expect_refusal(with(wave, "normalised_rms", "cost_to_reach") + height,
                 "choices.toml:11: basket.metric = \"cost_to_reach\": expected a metric of one");
  expect_refusal(with(wave, "elevation@right", "elevation@rigt") + height,
                 "choices.toml:10: basket.quantity = \"elevation@rigt\": expected a compared "
                 "quantity, one of ");
  expect_refusal(wave + with(height, "elevation@right", "elevation@rigt"),
                 "choices.toml:16: basket.quantity = \"elevation@rigt\": expected a compared "
                 "quantity, one of ");
  expect_refusal(with(wave, "\"theory\"", "\"theorie\"") + height,
                 "choices.toml:9: basket.reference = \"theorie\": expected a run other than the "
                 "candidate, one of ");
  expect_refusal(with(wave, "reference = \"theory\"\n", "") + height,
                 "choices.toml:6: basket.reference is missing: expected");
  expect_refusal(wave + height + "reference = \"theory\"\n",
                 "choices.toml:20: basket.reference = \"theory\": expected no reference: "
                 "largest_magnitude is measured on the candidate alone");
  expect_refusal(with(wave, "\"whole\"", "\"forced\"") + height,
                 "choices.toml:12: basket.mode = \"forced\": expected what normalised_rms is "
                 "measured on, which is whole");
  for (const char* goal : {"0", "-0.01"})
    expect_refusal(with(wave, "goal = 0.01", std::string("goal = ") + goal) + height,
                   std::string("choices.toml:13: basket.goal = ") + goal +
                       ": expected a number > 0, without unit");
  expect_refusal(with(wave, "goal = 0.01", "goal = \"small\"") + height,
                 "choices.toml:13: basket.goal = \"small\": expected a number > 0");
  expect_refusal(wave + with(height, "goal = 0.02\n", ""),
                 "choices.toml:14: basket.goal is missing: expected a number > 0, in m");
  expect_refusal(with(wave, "goal = 0.01", "limit = 0.01") + height,
                 "choices.toml:13: basket.limit = 0.01: expected only these keys here: case, "
                 "title, run_suffix, reference, quantity, metric, mode, goal; nearest known key: ");
}

TEST_F(Basket, MeasuresAnySeriesOfTheCandidateAlone) {
  const auto basket = read(wave + with(height, "elevation@right", "mach_number"));
  EXPECT_EQ(basket.at(1).row.quantity, "mach_number");
  EXPECT_EQ(basket[1].row.unit, "1");
}

TEST_F(Basket, TakesTheSuffixOfTheRunsThatAreMeasured) {
  const std::string disordered = with(wave, "goal = 0.01", "goal = 0.1\nrun_suffix = \"_b\"");
  const auto basket = read(wave + height + disordered);
  EXPECT_EQ(basket.at(0).run_suffix, "");
  EXPECT_EQ(basket.at(2).run_suffix, "_b");
}

TEST_F(Basket, TellsTheMistakesOfAllItsTablesAtOnce) {
  const std::string message =
      refusal(with(wave, "\"small\"", "\"smal\"") + with(height, "goal = 0.02", "goal = -1"));
  EXPECT_NE(message.find("choices.toml:7: basket.case"), std::string::npos) << message;
  EXPECT_NE(message.find("choices.toml:19: basket.goal = -1"), std::string::npos) << message;
}

TEST_F(Basket, RefusesAMeasureThatStandsTwice) {
  expect_refusal(wave + height + with(wave, "goal = 0.01", "goal = 0.02"),
                 "choices.toml:20: basket = normalised_rms of small a second time: expected each "
                 "measure once; the first is on line 6");
}

TEST_F(Basket, RefusesABasketOfASingleCase) {
  expect_refusal(wave + with(height, "\"other\"", "\"small\""),
                 "choices.toml:15: basket.case = \"small\": expected measures of two cases or more "
                 "in a basket");
}

}  // namespace
}  // namespace slosh::basket_test

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "reports/summary/results_json.hpp"
#include "reports/tables/case_tables.hpp"
#include "verification/tests/field_results.hpp"
#include "verification/tests/surge_results.hpp"

namespace slosh::field_table_test {
namespace {

double at_rest(double, double z) { return 9810 * (0.35 - z); }

// The particles lack liquid above 0.28 m, and the coarse mesh is 500 Pa high at the second moment.
CaseAssessment with_fields() {
  CaseDefinition definition = surge_case();
  definition.snapshot_times = {2, 4};
  CaseRuns runs = surge_runs();
  for (const double time : definition.snapshot_times) {
    const double offset = time == 4 ? 500 : 0;
    const auto high = [offset](double x, double z) { return at_rest(x, z) + offset; };
    const auto leave = [&](const char* run, const Tiles& tiles, const PressureAt& pressure) {
      runs.results.at(run).snapshots.push_back(tiled_field(time, tiles, pressure));
    };
    leave("fine_mesh", {.width = 0.02, .height = 0.01}, at_rest);
    leave("particles", {.width = 0.005, .height = 0.005, .depth = 0.28}, at_rest);
    leave("coarse_mesh", {.width = 0.02, .height = 0.01}, high);
  }
  return assess(definition, runs);
}

TEST(FieldTable, HasARowForARunAndAColumnForAMoment) {
  const auto table = field_table(with_fields());
  ASSERT_TRUE(table);
  EXPECT_EQ(table->header, (std::vector<std::string>{
                               "run", "against", "rms at 2 s [%]", "rms at 4 s [%]", "mean rms [%]",
                               "tension [%]", "lowest [Pa]", "not covered [%]", "excess [%]"}));
  ASSERT_EQ(table->rows.size(), 2u);
  EXPECT_EQ(table->rows[0], (std::vector<std::string>{"particles", "fine_mesh", "0.0", "0.0", "0.0",
                                                      "0.00 (0.00)", "736 (736)", "20.0", "0.0"}));
  EXPECT_EQ(table->rows[1],
            (std::vector<std::string>{"coarse_mesh", "fine_mesh", "0.0", "14.6", "7.3",
                                      "0.00 (0.00)", "49 (49)", "0.0", "0.0"}));
}

TEST(FieldTable, IsLeftOutWhereNoFieldsWereCompared) {
  EXPECT_FALSE(field_table(assess(surge_case(), surge_runs())));
}

TEST(FieldTable, HasItsNumbersInTheResultsForPrograms) {
  const auto json = nlohmann::json::parse(results_json("a_campaign", false, {with_fields()}));
  const auto& pair = json["cases"][0]["fields"][1];
  EXPECT_EQ(pair["candidate"], "coarse_mesh");
  EXPECT_EQ(pair["reference"], "fine_mesh");
  EXPECT_EQ(pair["moments"][1]["time_s"], 4);
  EXPECT_NEAR(pair["moments"][1]["pressure_rms_Pa"], 500, 1e-6);
  EXPECT_NEAR(pair["moments"][1]["pressure_rms"], 500 / (9810 * 0.35), 1e-9);
  EXPECT_NEAR(json["cases"][0]["fields"][0]["moments"][0]["uncovered_share"], 0.2, 1e-9);
  const auto without = nlohmann::json::parse(
      results_json("a_campaign", false, {assess(surge_case(), surge_runs())}));
  EXPECT_FALSE(without["cases"][0].contains("fields"));
}

TEST(FieldTable, NamesAFieldThatCannotBeCompared) {
  CaseAssessment assessment = with_fields();
  assessment.runs.results.at("particles").snapshots.pop_back();
  const CaseAssessment again = assess(assessment.definition, assessment.runs);
  EXPECT_FALSE(fields_compared(again, "particles", "fine_mesh"));
  EXPECT_TRUE(fields_compared(again, "coarse_mesh", "fine_mesh"));
  EXPECT_EQ(again.not_comparable.back(),
            "the fields of particles against fine_mesh: particles has no field at 4 s");
}

}  // namespace
}  // namespace slosh::field_table_test

#include "verification/runs/filtered_pressures.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "verification/series/low_pass_filter.hpp"
#include "verification/tests/sample_case.hpp"

namespace slosh::filtered_pressures_test {
namespace {

TimeSeries pressure(const std::string& name) {
  TimeSeries series{name, "Pa", {}, {}};
  for (int i = 0; i <= 1000; ++i) {
    series.time.push_back(0.001 * i);
    series.value.push_back(std::sin(3.0 * i));
  }
  return series;
}

CaseDefinition filtered_case() {
  CaseDefinition definition = sample_case();
  definition.pressure_gauges = {
      {.name = "B", .wall = Wall::left, .position = 0.1, .filter_cutoff = 50},
      {.name = "C", .wall = Wall::left, .position = 0.2}};
  return definition;
}

std::vector<std::string> names_of(const RunResult& result) {
  std::vector<std::string> names;
  for (const TimeSeries& one : result.series) names.push_back(one.name);
  return names;
}

TEST(FilteredPressures, StandBesideThoseOfGaugesWithACutoff) {
  RunResult result;
  result.series = {pressure("wall_pressure@B"), pressure("wall_pressure@C")};
  EXPECT_TRUE(add_filtered_pressures(filtered_case(), result).empty());
  EXPECT_EQ(names_of(result), (std::vector<std::string>{"wall_pressure@B", "wall_pressure@C",
                                                        "wall_pressure@B/filtered"}));
  EXPECT_EQ(result.series[2].value, low_pass(pressure("wall_pressure@B"), 50).value);
}

TEST(FilteredPressures, ReplaceThoseThatTheResultHas) {
  RunResult result;
  result.series = {pressure("wall_pressure@B/filtered"), pressure("wall_pressure@B")};
  add_filtered_pressures(filtered_case(), result);
  EXPECT_EQ(names_of(result),
            (std::vector<std::string>{"wall_pressure@B", "wall_pressure@B/filtered"}));
  EXPECT_LT(std::abs(result.series[1].value[500]), 0.01);
}

TEST(FilteredPressures, OfARecordHaveItsBandFilteredAlike) {
  RunResult result;
  result.series = {pressure("wall_pressure@B"), pressure("wall_pressure@B/lower"),
                   pressure("wall_pressure@B/upper")};
  add_filtered_pressures(filtered_case(), result);
  EXPECT_EQ(result.at("wall_pressure@B/filtered/lower").value,
            result.at("wall_pressure@B/filtered").value);
  EXPECT_EQ(result.at("wall_pressure@B/filtered/upper").value,
            result.at("wall_pressure@B/filtered").value);
}

TEST(FilteredPressures, SayWhatCannotBeFiltered) {
  RunResult result;
  result.series = {pressure("wall_pressure@B")};
  result.series[0].time.resize(5);
  result.series[0].value.resize(5);
  EXPECT_EQ(add_filtered_pressures(filtered_case(), result).size(), 1U);
  EXPECT_EQ(result.series.size(), 1U);
}

}  // namespace
}  // namespace slosh::filtered_pressures_test

#include "verification/runs/filtered_pressures.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "verification/input/case_file_error.hpp"
#include "verification/runs/fitting_spacing.hpp"
#include "verification/runs/run_case.hpp"
#include "verification/series/low_pass_filter.hpp"
#include "verification/series/time_series.hpp"
#include "verification/tests/messages.hpp"
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

// 2.5 m of water in a tank whose lower corners are cut off by chamfers of 2 m.
class DryGauges : public ::testing::Test {
 protected:
  DryGauges() {
    definition.tank.length = 10;
    definition.tank.height = 4;
    definition.tank.outline = {{2, 0}, {8, 0}, {10, 2}, {10, 4}, {0, 4}, {0, 2}};
    definition.liquid.fill_depth = 2.5;
    definition.gauges = {{"chamfer", 0.5}, {"floor", 5}};
    run.name = "run";
    run.solver = SphRun{"recommended", 0.2, 0.2};
    for (const char* name : {"elevation@chamfer", "highest_surface@floor"})
      result.series.push_back({name, "m", {0, 1, 2, 3}, {0.1, -2.512, -0.9, not_a_number}});
  }

  CaseDefinition definition{};
  RunDefinition run{};
  RunResult result{};
};

TEST_F(DryGauges, ReadTheFloorBelowThem) {
  raise_dry_gauges(definition, run, result);
  const std::vector<double>&chamfer = result.series[0].value, &floor = result.series[1].value;
  EXPECT_DOUBLE_EQ(chamfer[1], 1.5 - 2.5);
  EXPECT_EQ(chamfer[0], 0.1);
  EXPECT_EQ(chamfer[2], -0.9);
  EXPECT_TRUE(std::isnan(chamfer[3]));
  EXPECT_DOUBLE_EQ(floor[1], -2.5);
}

TEST_F(DryGauges, ReadTheBottomOfARectangle) {
  definition.tank.outline.clear();
  raise_dry_gauges(definition, run, result);
  EXPECT_DOUBLE_EQ(result.series[0].value[1], -2.5);
}

TEST_F(DryGauges, OfAnotherProgramStayAsTheyAre) {
  run.solver = ExternalRun{};
  raise_dry_gauges(definition, run, result);
  EXPECT_EQ(result.series[0].value[1], -2.512);
}

const std::string refusal = "particle_spacing = 0.03 m: expected a whole number of particles";

CaseDefinition tank_of(double length, double depth) {
  CaseDefinition definition = sample_case();
  definition.tank.length = length;
  definition.liquid.fill_depth = depth;
  return definition;
}

RunDefinition run_with(double spacing) {
  return sample_run(SphRun{
      .scheme = "recommended", .particle_spacing = spacing, .surface_particle_spacing = spacing});
}

TEST(FittingSpacing, IsTheNearestThatDividesLengthAndDepth) {
  EXPECT_NEAR(*nearest_fitting_spacing(tank_of(0.6, 0.12), 0.013), 0.6 / 45, 1e-12);
  EXPECT_NEAR(*nearest_fitting_spacing(tank_of(1, 0.35), 0.05), 0.05, 1e-12);
  EXPECT_NEAR(*nearest_fitting_spacing(tank_of(1, 0.1), 0.03), 1 / 30.0, 1e-12);
}

TEST(FittingSpacing, OfADamDividesItsColumn) {
  CaseDefinition dam = tank_of(1, 0.1);
  dam.liquid.column_width = 0.06;
  EXPECT_NEAR(*nearest_fitting_spacing(dam, 0.018), 0.02, 1e-12);
}

TEST(FittingSpacing, OfLengthsWithoutACommonDivisorIsWithinTheStretchOfALattice) {
  const CaseDefinition definition = tank_of(1, 0.317);
  const double found = *nearest_fitting_spacing(definition, 0.03);
  EXPECT_EQ(spacing_hint(refusal, definition, run_with(found)), "");
}

TEST(FittingSpacing, IsNotSoughtInATankThatIsNoRectangle) {
  CaseDefinition definition = tank_of(1, 0.1);
  definition.tank.outline = {{0, 0}, {1, 0}, {0.5, 1}};
  EXPECT_FALSE(nearest_fitting_spacing(definition, 0.03));
  EXPECT_EQ(spacing_hint(refusal, definition, run_with(0.03)), "");
}

TEST(FittingSpacing, IsToldWhereARunsSpacingDoesNotFit) {
  const CaseDefinition definition = tank_of(1, 0.1);
  EXPECT_EQ(spacing_hint(refusal, definition, run_with(0.03)),
            "; the nearest that divides both is 0.0333333 m");
  EXPECT_EQ(spacing_hint(refusal, definition, run_with(0.025)), "");
  // Another key is refused: the spacing is no part of it.
  EXPECT_EQ(spacing_hint("variant = \"none\": expected one of", definition, run_with(0.03)), "");
  try {
    require_runnable(definition, run_with(0.03));
    ADD_FAILURE() << "the run was not refused";
  } catch (const CaseFileError& error) {
    EXPECT_TRUE(holds(std::string(error.what()), "; the nearest that divides both is 0.0333333 m"))
        << error.what();
  }
}

}  // namespace
}  // namespace slosh::filtered_pressures_test

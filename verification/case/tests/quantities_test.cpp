#include "verification/case/quantities.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "verification/results/taken_series.hpp"

namespace slosh::quantities_test {
namespace {

struct History {
  std::vector<double> time{0}, value{1};
};

struct SolverOutput {
  std::map<std::string, History> elevation{{"a", {}}}, highest_surface{{"a", {}}},
      wall_pressure{{"b", {}}}, velocity_x{{"p", {}}}, velocity_z{{"p", {}}}, pressure{{"p", {}}},
      wall_force_x{{"left", {}}}, wall_force_z{{"left", {}}};
  History front_position, force_x, force_z, moment, momentum_x, momentum_z;
};

TEST(Quantities, HaveATitleALabelAndAUnitThatFiguresCanShow) {
  for (const Quantity& one : quantity_table()) {
    EXPECT_STRNE(one.title, "") << one.name;
    EXPECT_STRNE(one.label, "") << one.name;
    const bool is_in_millimetres = one.unit == std::string("m");
    EXPECT_STREQ(one.shown_unit, is_in_millimetres ? "mm" : one.unit) << one.name;
    EXPECT_EQ(one.shown_per_si, is_in_millimetres ? 1000 : 1) << one.name;
  }
}

TEST(Quantities, AreThoseThatSolversRecordAndInTheSameUnits) {
  RunResult result;
  SolverOutput output;
  take_common_series(output, result);
  std::set<std::pair<std::string, MeasuredAt>> taken;
  for (const TimeSeries& series : result.series) {
    ASSERT_NE(find_quantity(series.name), nullptr) << series.name;
    EXPECT_EQ(series.unit, unit_of(series.name)) << series.name;
    const Quantity* quantity = find_quantity(series.name);
    taken.emplace(quantity->name, quantity->at);
  }
  EXPECT_EQ(taken.size(), quantity_table().size());
}

TEST(Quantities, AreMeasuredAtGaugesAtProbesOnWallsOrInTheTank) {
  EXPECT_EQ(find_quantity("elevation@right")->at, MeasuredAt::surface_gauge);
  EXPECT_EQ(find_quantity("wall_pressure@b/filtered")->at, MeasuredAt::pressure_gauge);
  EXPECT_EQ(find_quantity("force_x")->at, MeasuredAt::tank);
  EXPECT_EQ(find_quantity("force_x@left")->at, MeasuredAt::wall);
  EXPECT_EQ(find_quantity("velocity_z@p")->at, MeasuredAt::probe);
  for (const char* none : {"", "elevation", "force_x@a", "liquid_volume", "velocity_x"})
    EXPECT_EQ(find_quantity(none), nullptr) << none;
}

}  // namespace
}  // namespace slosh::quantities_test

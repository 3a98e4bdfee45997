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

TEST(Quantities, AreNoLargerThanTheTankAllows) {
  CaseDefinition definition{};
  definition.gravity = 9.81;
  definition.tank.length = 3;
  definition.tank.height = 1;
  definition.liquid.fill_depth = 0.5;
  definition.liquid.density = 1000;
  definition.duration = 10;
  EXPECT_EQ(largest_in_tank(definition, "m"), 3);
  // A fall of 4 m ends at 8.86 m/s.
  EXPECT_NEAR(largest_in_tank(definition, "m/s"), 88.6, 0.1);
  EXPECT_NEAR(largest_in_tank(definition, "Pa"), 1.33e7, 1e5);
  EXPECT_NEAR(largest_in_tank(definition, "N/m"), 5.32e7, 1e6);
  definition.motion.surge = MotionHistory{SineMotion{.amplitude = 2, .angular_frequency = 3}};
  EXPECT_NEAR(largest_in_tank(definition, "m/s"), 148.6, 0.2);
  EXPECT_EQ(largest_in_tank(definition, "J/m"), 1e9);
}

}  // namespace
}  // namespace slosh::quantities_test

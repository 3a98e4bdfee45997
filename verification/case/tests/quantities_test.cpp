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
      wall_pressure{{"b", {}}};
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
  std::set<std::string> taken;
  for (const TimeSeries& series : result.series) {
    ASSERT_NE(find_quantity(series.name), nullptr) << series.name;
    EXPECT_EQ(series.unit, unit_of(series.name)) << series.name;
    taken.insert(find_quantity(series.name)->name);
  }
  EXPECT_EQ(taken.size(), quantity_table().size());
}

TEST(Quantities, AreMeasuredAtGaugesOrInTheTank) {
  EXPECT_EQ(find_quantity("elevation@right")->at, MeasuredAt::surface_gauge);
  EXPECT_EQ(find_quantity("wall_pressure@b/filtered")->at, MeasuredAt::pressure_gauge);
  EXPECT_EQ(find_quantity("force_x")->at, MeasuredAt::tank);
  for (const char* none : {"", "elevation", "force_x@a", "liquid_volume"})
    EXPECT_EQ(find_quantity(none), nullptr) << none;
}

}  // namespace
}  // namespace slosh::quantities_test

#include <gtest/gtest.h>

#include <cmath>

#include "verification/runs/filtered_pressures.hpp"
#include "verification/series/time_series.hpp"

namespace slosh::dry_gauges_test {
namespace {

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

}  // namespace
}  // namespace slosh::dry_gauges_test

// Pressure gauges, snapshot times and the compared quantities.
#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "verification/case/quantities.hpp"
#include "verification/tests/trial_case.hpp"

namespace slosh::pressure_gauge_test {
namespace {

// Before [comparison], line 31: the keys stand from line 32 on. The tank is 2 m long and 1 m high,
// sampled at 100 Hz.
Edit gauge(const std::string& keys) {
  return {"[comparison]", "[[pressure_gauge]]\n" + keys + "[comparison]"};
}

TEST(PressureGauge, IsAPointUnlessToldAndHasNoFilter) {
  const CaseDefinition definition =
      read_text(edited(gauge("name = \"b\"\nwall = \"left\"\nposition_m = 0.093\n")));
  ASSERT_EQ(definition.pressure_gauges.size(), 1u);
  EXPECT_EQ(definition.pressure_gauges[0].wall, Wall::left);
  EXPECT_EQ(definition.pressure_gauges[0].position, 0.093);
  EXPECT_EQ(definition.pressure_gauges[0].width, 0);
  EXPECT_FALSE(definition.pressure_gauges[0].filter_cutoff);
}

TEST(PressureGauge, MayReachToTheWallsEnds) {
  const CaseDefinition definition =
      read_text(edited(gauge("name = \"a\"\nwall = \"right\"\nposition_m = 0.9\nwidth_m = 0.2\n"
                             "filter_cutoff_Hz = 49.9\n[[pressure_gauge]]\nname = \"b\"\n"
                             "wall = \"bottom\"\nposition_m = 2.0\n")));
  EXPECT_EQ(definition.pressure_gauges.at(0).wall, Wall::right);
  EXPECT_EQ(definition.pressure_gauges.at(0).width, 0.2);
  EXPECT_EQ(definition.pressure_gauges.at(0).filter_cutoff, 49.9);
  EXPECT_EQ(definition.pressure_gauges.at(1).wall, Wall::bottom);
}

TEST(PressureGauge, MayBeInTheRoof) {
  const CaseDefinition definition =
      read_text(edited(gauge("name = \"a\"\nwall = \"roof\"\nposition_m = 1.9\nwidth_m = 0.2\n")));
  EXPECT_EQ(definition.pressure_gauges.at(0).wall, Wall::roof);
  EXPECT_EQ(definition.pressure_gauges.at(0).position, 1.9);
  EXPECT_TRUE(complaint_about(gauge("name = \"b\"\nwall = \"roof\"\nposition_m = 2.1\n"))
                  .starts_with("trial.toml:34: pressure_gauge.position_m = 2.1: expected a number "
                               "from 0 to the tank's length (2), in m from the left wall"));
}

TEST(PressureGauge, MayBeTheOnlyGauge) {
  std::string text = edited(gauge("name = \"b\"\nwall = \"left\"\nposition_m = 0.093\n"));
  const std::size_t gauges = text.find("[[gauge]]");
  text.erase(gauges, text.find("[[pressure_gauge]]") - gauges);
  text = text.substr(0, text.find("[[gate]]"));
  EXPECT_EQ(compared_quantities(read_text(text)),
            (std::vector<std::string>{"wall_pressure@b", "force_x", "force_z", "momentum_x",
                                      "momentum_z"}));
}

TEST(PressureGauge, IsRefusedWhereItMakesNoSense) {
  const std::string named = "name = \"b\"\n", left = "name = \"b\"\nwall = \"left\"\n";
  const std::vector<std::pair<std::string, std::string>> gauges{
      {"name = \"a b\"\n", "trial.toml:32: pressure_gauge.name = \"a b\": expected a name of"},
      {named + "position_m = 0.1\n",
       "trial.toml:31: pressure_gauge.wall is missing: expected a wall, one of left, right, "
       "bottom"},
      {named + "wall = \"lift\"\n",
       "trial.toml:33: pressure_gauge.wall = \"lift\": expected a wall, one of left, right, "
       "bottom, roof; nearest: left"},
      {left,
       "trial.toml:31: pressure_gauge.position_m is missing: expected a number from 0 to the "
       "tank's height (1), in m from the bottom"},
      {left + "position_m = 1.001\n",
       "trial.toml:34: pressure_gauge.position_m = 1.001: expected a number from 0 to the tank's "
       "height (1)"},
      {left + "position_m = -0.001\n", "trial.toml:34: pressure_gauge.position_m = -0.001"},
      {left + "position_m = nan\n", "trial.toml:34: pressure_gauge.position_m = nan"},
      {named + "wall = \"bottom\"\nposition_m = 2.1\n",
       "trial.toml:34: pressure_gauge.position_m = 2.1: expected a number from 0 to the tank's "
       "length (2), in m from the left wall"},
      {left + "position_m = 0.005\nwidth_m = 0.011\n",
       "trial.toml:35: pressure_gauge.width_m = 0.011: expected a number >= 0 and <= 0.01, in m: "
       "the whole sensor lies on the wall"},
      {left + "position_m = 0.999\nwidth_m = 0.01\n",
       "trial.toml:35: pressure_gauge.width_m = 0.01: expected a number >= 0 and <= 0.002"},
      {left + "position_m = 0.1\nwidth_m = -0.01\n",
       "trial.toml:35: pressure_gauge.width_m = -0.01: expected a number >= 0"},
      {left + "position_m = 0.1\nfilter_cutoff_Hz = 50\n",
       "trial.toml:35: pressure_gauge.filter_cutoff_Hz = 50: expected a number > 0 and below half "
       "the sampling rate (50), in Hz"},
      {left + "position_m = 0.1\nfilter_cutoff_Hz = 0\n",
       "trial.toml:35: pressure_gauge.filter_cutoff_Hz = 0: expected a number > 0"},
      {left + "position_m = 0.1\nhight_m = 0.1\n",
       "trial.toml:35: pressure_gauge.hight_m = 0.1: expected only these keys here: name, wall, "
       "position_m, x_m, z_m, width_m, filter_cutoff_Hz; nearest known key: width_m"},
      {left + "position_m = 0.1\n[[pressure_gauge]]\n" + left + "position_m = 0.2\n",
       "trial.toml:36: pressure_gauge.name = \"b\": expected a name that no other pressure_gauge "
       "has"}};
  for (const auto& [keys, wanted] : gauges) {
    const std::string message = complaint_about(gauge(keys));
    EXPECT_TRUE(message.starts_with(wanted)) << "got:    " << message << "\nwanted: " << wanted;
  }
}

TEST(PressureGauge, IsNotBehindAnObstacle) {
  const auto complaint_beside = [](const std::string& wall, const std::string& place,
                                   const std::string& obstacle) {
    return complaint_about(gauge("name = \"b\"\nwall = \"" + wall + "\"\nposition_m = " + place +
                                 "\nwidth_m = 0.02\n[[obstacle]]\nname = \"step\"\n" + obstacle));
  };
  const std::string step = "left_m = 0\nright_m = 0.3\nbottom_m = 0\ntop_m = 0.2\n";
  EXPECT_TRUE(complaint_beside("left", "0.205", step)
                  .starts_with("trial.toml:37: obstacle.name = \"step\": expected an obstacle "
                               "elsewhere: it covers the pressure gauge b at 0.205 m"));
  EXPECT_EQ(complaint_beside("left", "0.215", step), "");
  EXPECT_NE(complaint_beside("bottom", "0.1", step), "");
  EXPECT_EQ(complaint_beside("bottom", "0.4", step), "");
  EXPECT_EQ(complaint_beside("right", "0.1", step), "");
  EXPECT_EQ(
      complaint_beside("bottom", "0.1", "left_m = 0\nright_m = 0.3\nbottom_m = 0.1\ntop_m = 0.2\n"),
      "");
  EXPECT_NE(
      complaint_beside("roof", "0.1", "left_m = 0\nright_m = 0.3\nbottom_m = 0.8\ntop_m = 1\n"),
      "");
  EXPECT_EQ(
      complaint_beside("roof", "0.1", "left_m = 0\nright_m = 0.3\nbottom_m = 0.8\ntop_m = 0.9\n"),
      "");
  EXPECT_NE(
      complaint_beside("right", "0.3", "left_m = 1.8\nright_m = 2\nbottom_m = 0.25\ntop_m = 0.4\n"),
      "");
}

TEST(ComparedQuantities, HaveTheCasesElevationsFirstAndThenItsWallPressures) {
  CaseDefinition definition{};
  definition.gauges = {{"right", 1.95}};
  definition.pressure_gauges = {{"b", Wall::left, 0.1, 0, 10}, {"c", Wall::bottom, 0.1}};
  EXPECT_EQ(compared_quantities(definition),
            (std::vector<std::string>{
                "elevation@right", "wall_pressure@b", "wall_pressure@b/filtered", "wall_pressure@c",
                "force_x", "force_z", "momentum_x", "momentum_z", "highest_surface@right"}));
  definition.liquid.column_width = 0.1;
  definition.motion.roll = RollDefinition{SineMotion{0.1, 2}, 0, 0};
  const auto rolling_dam = compared_quantities(definition);
  EXPECT_EQ(rolling_dam.front(), "front_position");
  EXPECT_NE(std::find(rolling_dam.begin(), rolling_dam.end(), "moment"), rolling_dam.end());
  for (const std::string& quantity : rolling_dam) EXPECT_NE(unit_of(quantity), "");
}

TEST(ComparedQuantities, HaveTheirUnits) {
  const std::vector<std::pair<std::string, std::string>> units{
      {"front_position", "m"},   {"elevation@a", "m"},   {"wall_pressure@a", "Pa"},
      {"force_x", "N/m"},        {"force_z", "N/m"},     {"wall_pressure@a/filtered", "Pa"},
      {"moment", "N"},           {"momentum_x", "kg/s"}, {"momentum_z", "kg/s"},
      {"highest_surface@a", "m"}};
  for (const auto& [quantity, unit] : units) EXPECT_EQ(unit_of(quantity), unit) << quantity;
  for (const char* none : {"", "force", "force_xy", "elevation", "velocity@a", "liquid_volume"}) {
    EXPECT_THROW(unit_of(none), std::invalid_argument) << none;
    EXPECT_FALSE(has_modes(none)) << none;
  }
}

TEST(ComparedQuantities, HaveModesWhereLinearTheoryHasThem) {
  for (const char* swings : {"elevation@a", "wall_pressure@a", "wall_pressure@a/filtered",
                             "force_x", "moment", "momentum_x", "highest_surface@a"})
    EXPECT_TRUE(has_modes(swings)) << swings;
  for (const char* does_not : {"front_position", "force_z", "momentum_z"})
    EXPECT_FALSE(has_modes(does_not)) << does_not;
}

Edit row(const std::string& quantity, const std::string& mode, const std::string& metric,
         const std::string& unit) {
  return {
      "quantity = \"elevation@right\"\nmode = \"forced\"\nmetric = \"amplitude_error\"\n"
      "unit = \"1\"",
      "quantity = \"" + quantity + "\"\nmode = \"" + mode + "\"\nmetric = \"" + metric +
          "\"\nunit = \"" + unit + "\""};
}

TEST(GateOnAnyQuantity, HasTheUnitOfItsMetricOrOfTheQuantity) {
  EXPECT_EQ(complaint_about(row("force_x", "forced", "phase_lag", "deg")), "");
  EXPECT_EQ(complaint_about(row("force_x", "whole", "mean_offset", "N/m")), "");
  EXPECT_EQ(complaint_about(row("momentum_z", "whole", "aligned_rms", "1")), "");
  EXPECT_EQ(complaint_about(row("elevation@right", "whole", "mean_offset", "m")), "");
  EXPECT_TRUE(complaint_about(row("force_x", "whole", "mean_offset", "m"))
                  .starts_with("trial.toml:58: gate.unit = \"m\": expected the unit of "
                               "mean_offset, which is N/m"));
  EXPECT_TRUE(complaint_about(row("force_z", "forced", "amplitude_error", "1"))
                  .starts_with("trial.toml:56: gate.mode = \"forced\": expected what "
                               "amplitude_error is measured on, of which there is none"));
  EXPECT_TRUE(complaint_about(row("moment", "forced", "amplitude_error", "1"))
                  .starts_with("trial.toml:55: gate.quantity = \"moment\": expected a compared "
                               "quantity, one of"))
      << "the tank does not roll";
}

TEST(GateOnAnyQuantity, OfTheCandidateAloneHasTheQuantitysUnitToo) {
  const auto complaint_about_unit = [](const std::string& unit) {
    return complaint_about(
        {"reference = \"theory\"\nquantity = \"elevation@right\"\n"
         "mode = \"forced\"\nmetric = \"amplitude_error\"\nunit = \"1\"",
         "quantity = \"highest_surface@left\"\nmode = \"whole\"\n"
         "metric = \"largest_magnitude\"\nunit = \"" +
             unit + "\""});
  };
  EXPECT_EQ(complaint_about_unit("m"), "");
  EXPECT_TRUE(complaint_about_unit("mm").starts_with(
      "trial.toml:57: gate.unit = \"mm\": expected the unit of highest_surface@left, which is m"));
}

Edit snapshots(const std::string& times) {
  return {"sample_interval_s = 0.01", "sample_interval_s = 0.01\nsnapshot_times_s = " + times};
}

TEST(SnapshotTimes, AreIncreasingMultiplesOfTheSampleInterval) {
  EXPECT_EQ(read_text(edited(snapshots("[0.01, 3.45, 3.95, 4.35, 4.75, 20]"))).snapshot_times,
            (std::vector<double>{0.01, 3.45, 3.95, 4.35, 4.75, 20}));
  EXPECT_TRUE(read_text(valid_text).snapshot_times.empty());
}

TEST(SnapshotTimes, AreRefusedByTheirOwnLine) {
  const std::string each =
      "expected a number > 0 and <= the duration (20), a multiple of sample_interval_s (0.01), in "
      "s";
  const std::vector<std::pair<std::string, std::string>> lists{
      {"3", "trial.toml:25: time.snapshot_times_s = 3: expected an array of numbers, each a"},
      {"[1, 0]", "trial.toml:25: time.snapshot_times_s = 0: " + each},
      {"[1,\n20.01]", "trial.toml:26: time.snapshot_times_s = 20.01: " + each},
      {"[3.455]", "trial.toml:25: time.snapshot_times_s = 3.455: " + each},
      {"[nan]", "trial.toml:25: time.snapshot_times_s = nan: " + each},
      {"[\"1\"]", "trial.toml:25: time.snapshot_times_s = \"1\": " + each},
      {"[2,\n\n1]",
       "trial.toml:27: time.snapshot_times_s = 1: expected a number above the one before it"},
      {"[2, 2]", "trial.toml:25: time.snapshot_times_s = 2: expected a number above the one"}};
  for (const auto& [times, wanted] : lists) {
    const std::string message = complaint_about(snapshots(times));
    EXPECT_TRUE(message.starts_with(wanted)) << "got:    " << message << "\nwanted: " << wanted;
  }
}

}  // namespace
}  // namespace slosh::pressure_gauge_test

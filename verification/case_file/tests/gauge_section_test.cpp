// Pressure gauges, snapshot times and the compared quantities.
#include <gtest/gtest.h>

#include <algorithm>

#include "verification/case/quantities.hpp"
#include "verification/case_file/tests/refusals.hpp"
#include "verification/tests/messages.hpp"
#include "verification/tests/trial_case.hpp"

namespace slosh::gauge_section_test {
namespace {

// The tank is 2 m long and 1 m high, sampled at 100 Hz.
std::string with_gauge(const std::string& keys) {
  return valid_text + "[[pressure_gauge]]\n" + keys;
}

TEST(PressureGauge, IsAPointUnlessToldAndHasNoFilter) {
  const CaseDefinition definition =
      read_text(with_gauge("name = \"b\"\nwall = \"left\"\nposition_m = 0.093\n"));
  ASSERT_EQ(definition.pressure_gauges.size(), 1u);
  EXPECT_EQ(definition.pressure_gauges[0].wall, Wall::left);
  EXPECT_EQ(definition.pressure_gauges[0].position, 0.093);
  EXPECT_EQ(definition.pressure_gauges[0].width, 0);
  EXPECT_FALSE(definition.pressure_gauges[0].filter_cutoff);
}

TEST(PressureGauge, MayReachToTheWallsEnds) {
  const CaseDefinition definition =
      read_text(with_gauge("name = \"a\"\nwall = \"right\"\nposition_m = 0.9\nwidth_m = 0.2\n"
                           "filter_cutoff_Hz = 49.9\n[[pressure_gauge]]\nname = \"b\"\n"
                           "wall = \"bottom\"\nposition_m = 2.0\n[[pressure_gauge]]\nname = \"c\"\n"
                           "wall = \"roof\"\nposition_m = 1.9\nwidth_m = 0.2\n"));
  EXPECT_EQ(definition.pressure_gauges.at(0).wall, Wall::right);
  EXPECT_EQ(definition.pressure_gauges.at(0).width, 0.2);
  EXPECT_EQ(definition.pressure_gauges.at(0).filter_cutoff, 49.9);
  EXPECT_EQ(definition.pressure_gauges.at(1).wall, Wall::bottom);
  EXPECT_EQ(definition.pressure_gauges.at(2).wall, Wall::roof);
}

TEST(PressureGauge, MayBeTheOnlyGauge) {
  std::string text = valid_text.substr(0, valid_text.find("[[gate]]"));
  const std::size_t gauges = text.find("[[gauge]]");
  text.erase(gauges, text.find("[comparison]") - gauges);
  text += "[[pressure_gauge]]\nname = \"b\"\nwall = \"left\"\nposition_m = 0.093\n";
  EXPECT_EQ(compared_quantities(read_text(text)),
            (std::vector<std::string>{"wall_pressure@b", "force_x", "force_z", "momentum_x",
                                      "momentum_z"}));
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

TEST(SnapshotTimes, AreIncreasingMultiplesOfTheSampleInterval) {
  const std::string text =
      with_keys(valid_text, "time.snapshot_times_s = [0.01, 3.45, 3.95, 4.35, 4.75, 20]");
  EXPECT_EQ(read_text(text).snapshot_times,
            (std::vector<double>{0.01, 3.45, 3.95, 4.35, 4.75, 20}));
  EXPECT_TRUE(read_text(valid_text).snapshot_times.empty());
  const std::string third =
      complaint_about({"duration_s = 20.0", "snapshot_times_s = [2,\n\n1]\nduration_s = 20.0"});
  EXPECT_TRUE(begins(third, "trial.toml:25: time.snapshot_times_s = 1: expected"));
}

// [[probe]] and wall_forces.

const std::string probe = "[[probe]]\nname = \"middle\"\nx_m = 1.0\nz_m = 0.2\n[comparison]\n";

TEST(ProbeSection, GivesAPlaceInTheTank) {
  const CaseDefinition definition = read_text(edited({"[comparison]\n", probe}));
  ASSERT_EQ(definition.probes.size(), 1u);
  EXPECT_EQ(definition.probes[0].name, "middle");
  EXPECT_EQ(definition.probes[0].x, 1);
  EXPECT_EQ(definition.probes[0].z, 0.2);
}

TEST(WallForcesKey, NamesTheWallsWhoseForcesAreCompared) {
  const CaseDefinition definition =
      read_text(edited({"[tank]\n", "wall_forces = [\"right\", \"bottom\"]\n[tank]\n"}));
  EXPECT_EQ(definition.wall_forces, (std::vector<Wall>{Wall::right, Wall::bottom}));
  const std::vector<std::string> compared = compared_quantities(definition);
  EXPECT_EQ(std::count(compared.begin(), compared.end(), "force_x@right"), 1);
  EXPECT_EQ(std::count(compared.begin(), compared.end(), "force_z@bottom"), 1);
  EXPECT_EQ(std::count(compared.begin(), compared.end(), "force_x@left"), 0);
}

}  // namespace
}  // namespace slosh::gauge_section_test

#include "verification/problems/stability/stability_map.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "sph/schemes.hpp"

namespace slosh::stability_map_test {
namespace {

// Stable below 3 + up; beyond 5 no guard tells.
StabilityMap invented() {
  return {.id = "invented",
          .title = "Invented",
          .caption = "",
          .across = {"a", {1, 2, 4, 6}},
          .up = {"b", {0, 0.5, 10}},
          .probe =
              [](double a, double b) {
                if (a < 3 + b) return Probe{Stability::stable, ""};
                if (a > 5) return Probe{Stability::unnoticed, ""};
                return Probe{Stability::unstable, "particle 7"};
              },
          .theory = [](double b) { return 3 + b; }};
}

TEST(StabilityMap, FindsTheLimitOfEachRowToTwoPerCent) {
  const MapOutcome found = explore(invented());
  ASSERT_EQ(found.measured.size(), 3u);
  EXPECT_NEAR(found.measured[0], 3, 0.06);
  EXPECT_NEAR(found.measured[1], 3.5, 0.07);
  EXPECT_TRUE(std::isnan(found.measured[2])) << "no limit in the map";
}

TEST(StabilityMap, CountsTheRunsThatGainEnergyUnnoticed) {
  EXPECT_EQ(explore(invented()).unnoticed, 2);
}

TEST(StabilityMap, TellsHowTheFirstUnstableRunOfEachRowWasFound) {
  const MapOutcome found = explore(invented());
  EXPECT_EQ(found.table.rows[0][3], "4");
  EXPECT_EQ(found.table.rows[0][4], "particle 7");
  EXPECT_EQ(found.table.rows[2][3], "");
}

TEST(StabilityMap, LeavesTheErrorOfTheTheorysLimitAndTheShareThatTheSchemeUses) {
  const StabilityMap map = invented();
  const auto measures = measures_of(map, explore(map), [](double) { return 1.5; });
  EXPECT_NEAR(measures[0].errors[0].error, 0, 0.02);
  EXPECT_NEAR(measures[1].errors[0].error, 0.5, 0.01);
  EXPECT_TRUE(std::isnan(measures[0].errors[2].error)) << "a map without a limit passes no gate";
  EXPECT_EQ(measures.at(2).errors[0].error, 2);
}

TEST(StabilityMap, CountsNothingUnnoticedWhereNoGuardWatches) {
  const StabilityMap map = invented();
  EXPECT_EQ(measures_of(
                map, explore(map), [](double) { return 1.5; }, Guarded::no)
                .size(),
            2u);
  EXPECT_EQ(map_measures("b", Guarded::no).size(), 2u);
  EXPECT_EQ(map_measures("b").size(), 3u);
}

TEST(ProbeOfWave, TellsAStableStepFromAnUnstableOne) {
  EXPECT_EQ(probe_of_wave(wave_scene(sph::recommended_at(0.8), 400)).stability, Stability::stable);
  const Probe stopped = probe_of_wave(wave_scene(sph::recommended_at(2.0), 2000));
  EXPECT_EQ(stopped.stability, Stability::unstable);
  EXPECT_NE(stopped.message.find("particle "), std::string::npos);
}

}  // namespace
}  // namespace slosh::stability_map_test

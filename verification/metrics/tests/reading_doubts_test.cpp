#include "verification/metrics/reading_doubts.hpp"

#include <gtest/gtest.h>

#include <tuple>

namespace slosh::reading_doubts_test {
namespace {

constexpr FlatExtreme at_zero{0, 1, 1.2, 30};

SensorReadings readings(const char* unit, SensorLimits limits) {
  return {"candidate", unit, limits, {0}};
}

std::size_t count(const char* unit, const SensorLimits& limits) {
  return doubts_of_readings(readings(unit, limits)).size();
}

TEST(ReadingDoubts, AreOfFlatsThatArePressuresCrestsAndBesideStepsAndOfSamplesThatAlternate) {
  EXPECT_EQ(count("Pa", {100, {}, at_zero, {}}), 1U);
  EXPECT_EQ(count("Pa", {100, {}, {}, at_zero}), 0U) << "it falls dry";
  for (const char* unit : {"N/m", "m"})
    EXPECT_EQ(count(unit, {100, {}, at_zero, at_zero}), 0U) << "it rests at either end";
  EXPECT_EQ(count("m", {100, 1.0, FlatExtreme{90, 1, 1.2, 30}, {}}), 1U);
  SensorLimits rough{100, {}, {}, {}};
  rough.roughness = 0.7;
  EXPECT_EQ(count("N/m", rough), 1U);
}

TEST(ReadingDoubts, AreOfReadingsThatAreHeldOrJoinedByLines) {
  for (const bool held : {true, false}) {
    SensorLimits limits{100, {}, {}, {}};
    limits.sparse = SparseReadings{held, 0.1, 4};
    const std::vector<std::string> doubts = doubts_of_readings(readings("m", limits));
    ASSERT_EQ(doubts.size(), 1U);
    EXPECT_NE(doubts[0].find(held ? "holds each reading for 0.1 s" : "readings 0.1 s apart"),
              std::string::npos)
        << doubts[0];
  }
}

// An impact is one too: a pressure that rises, and any load. Lost samples are of one value, which
// is none at which the quantity rests.
TEST(ReadingDoubts, TellSamplesThatLeaveTheirNeighboursUnlessTheyMayBeImpacts) {
  for (const auto& [unit, above, is_told] : {std::tuple{"m", true, true},
                                             {"m", false, true},
                                             {"Pa", false, true},
                                             {"Pa", true, false},
                                             {"N/m", false, false},
                                             {"N/m", true, false}}) {
    SensorLimits limits{100, {}, {}, {}};
    limits.isolated = IsolatedReadings{7, 1.5, 0.2, above};
    EXPECT_EQ(count(unit, limits), is_told ? 1U : 0U) << unit;
    limits.isolated->value = 40;
    EXPECT_EQ(count(unit, limits), 1U) << unit;
    SensorReadings resting = readings(unit, limits);
    resting.rests = {40};
    EXPECT_EQ(doubts_of_readings(resting).size(), 0U) << unit;
  }
}

TEST(ReadingDoubts, AreOfLostStretchesThatAreNoImpactAndNoFlat) {
  SensorLimits limits{100, {}, {}, {}};
  limits.lost = LostStretches{7, 1.5, 1.7, 0.2};
  const std::vector<std::string> doubts = doubts_of_readings(readings("m", limits));
  ASSERT_EQ(doubts.size(), 1U);
  EXPECT_NE(doubts[0].find("7 stretches of the candidate, as from 1.5 to 1.7 s"), std::string::npos)
      << doubts[0];
  for (const char* unit : {"N", "Pa"}) EXPECT_EQ(count(unit, limits), 0U) << unit;
  limits.lost->value = 90.5;
  limits.highest = FlatExtreme{90, 1, 1.2, 30};
  EXPECT_EQ(count("m", limits), 1U);  // of the flat
}

// The spray of an impact grows with it.
TEST(ReadingDoubts, AreOfDeparturesThatGrowWithTheWaveUnlessTheyMayBeImpacts) {
  SensorLimits limits{100, {}, {}, {}};
  limits.growth = 3;
  for (const auto& [unit, is_told] : {std::pair{"m", 1U}, {"m/s", 1U}, {"Pa", 0U}, {"N/m", 0U}})
    EXPECT_EQ(count(unit, limits), is_told) << unit;
}

}  // namespace
}  // namespace slosh::reading_doubts_test

#include "verification/metrics/reading_doubts.hpp"

#include <gtest/gtest.h>

namespace slosh::reading_doubts_test {
namespace {

constexpr FlatExtreme at_zero{0, 1, 1.2, 30};

SensorReadings readings(const char* unit, SensorLimits limits) {
  return {"candidate", unit, limits, {0}};
}

TEST(ReadingDoubts, AreOfAPressureWhoseCrestReadsZeroAndNotOfOneThatFallsDry) {
  EXPECT_EQ(doubts_of_readings(readings("Pa", {100, {}, at_zero, {}})).size(), 1U);
  EXPECT_TRUE(doubts_of_readings(readings("Pa", {100, {}, {}, at_zero})).empty());
}

TEST(ReadingDoubts, AreNotOfALoadOrASurfaceThatRestsAtEitherEnd) {
  for (const char* unit : {"N/m", "m"})
    EXPECT_TRUE(doubts_of_readings(readings(unit, {100, {}, at_zero, at_zero})).empty()) << unit;
}

TEST(ReadingDoubts, AreOfAFlatBesideSteps) {
  EXPECT_EQ(doubts_of_readings(readings("m", {100, 1.0, FlatExtreme{90, 1, 1.2, 30}, {}})).size(),
            1U);
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

}  // namespace
}  // namespace slosh::reading_doubts_test

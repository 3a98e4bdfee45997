#include "verification/series/interval_text.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace slosh::interval_text_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(IntervalText, EndsTheValueWhereItsIntervalEnds) {
  EXPECT_EQ(interval_text({0.00179, 0.34}), "0.00 ± 0.34");
  EXPECT_EQ(interval_text({-0.287, 0.19}), "-0.29 ± 0.19");
  EXPECT_EQ(interval_text({12.345, 0.0951}), "12.35 ± 0.10");
  EXPECT_EQ(interval_text({5.8412, 0.24}), "5.84 ± 0.24");
  EXPECT_EQ(interval_text({1234.5, 78}), "1230 ± 80");
  EXPECT_EQ(interval_text({3, 6.57}), "3.0 ± 6.6");
  EXPECT_EQ(interval_text({0, 0.5}), "0.00 ± 0.50");
  EXPECT_EQ(interval_text({5.62, 47.3}), "6 ± 47");
  EXPECT_EQ(interval_text({5.62, 4.73}), "6 ± 5");
}

TEST(IntervalText, HasNoNegativeZero) {
  EXPECT_EQ(interval_text({-0.00179, 0.34}), "0.00 ± 0.34");
  EXPECT_EQ(interval_text({-0.0, 0}), "0");
}

TEST(IntervalText, RoundsAnIntervalUpToTheFourthDigitOfTheValue) {
  EXPECT_EQ(interval_text({10.937, 0.0031}), "10.94 ± 0.01");
  EXPECT_EQ(interval_text({25000, 3}), "25000 ± 10");
}

TEST(IntervalText, LeavesOutAnIntervalThatNoShownDigitFeels) {
  EXPECT_EQ(interval_text({10.937, 9.72e-6}), "10.9");
  EXPECT_EQ(interval_text({-6.42e-5, 6.56e-10}), "-6.42e-05");
}

TEST(IntervalText, PutsASmallValueBeforeAPowerOfTen) {
  EXPECT_EQ(interval_text({-6.42e-5, 1.5e-6}), "(-6.42 ± 0.15)e-05");
  EXPECT_EQ(interval_text({1e-9, 4e-7}), "(0.0 ± 4.0)e-07");
}

TEST(IntervalText, GivesAValueWithoutAnIntervalThreeDigits) {
  EXPECT_EQ(interval_text({0.028049, 0}), "0.028");
  EXPECT_EQ(interval_text({9.2437, not_a_number}), "9.24");
  EXPECT_EQ(percent_interval_text({0.01, 0.0034}), "1.0 ± 0.3 %");
}

TEST(IntervalText, SaysThatAnInfiniteIntervalDeterminesNothing) {
  EXPECT_EQ(interval_text({3, infinity}), "not determined");
}

TEST(SlopeText, IsNotDeterminedWhereItsIntervalIncludesZero) {
  EXPECT_EQ(slope_text({-1.65, 52}), "not determined");
  EXPECT_EQ(slope_text({-1.65, 0.22}), "-1.65 ± 0.22");
  EXPECT_EQ(slope_text({-1.654, not_a_number}), "-1.65");
}

}  // namespace
}  // namespace slosh::interval_text_test

#include "verification/series/sample_moments.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace slosh::sample_moments_test {
namespace {

using Values = std::vector<double>;

TEST(SampleMoments, AreThoseOfASampleByHand) {
  const Values values{1, 2, 6};
  EXPECT_DOUBLE_EQ(mean(values), 3);
  EXPECT_DOUBLE_EQ(rms(values), std::sqrt(41.0 / 3));
  EXPECT_DOUBLE_EQ(rms(without_mean(values)), std::sqrt(14.0 / 3));
}

TEST(SampleMoments, LeaveASampleWithoutItsMeanOrAnother) {
  EXPECT_EQ(without_mean({1, 2, 6}), (Values{-2, -1, 3}));
  EXPECT_EQ(minus({1, 2, 6}, {1, 1, 4}), (Values{0, 1, 2}));
}

TEST(SampleMoments, AreNoNumberOfNoSamples) {
  EXPECT_TRUE(std::isnan(mean({})));
  EXPECT_TRUE(std::isnan(rms({})));
}

// Against printed tables (Fisher & Yates) and the normal distribution.
TEST(StudentT, HasTheQuantilesOfPrintedTables) {
  EXPECT_NEAR(t95(1), 12.706, 5e-4);
  EXPECT_NEAR(t95(2), 4.303, 5e-4);
  EXPECT_NEAR(t95(10), 2.228, 5e-4);
  EXPECT_NEAR(t95(1e9), 1.959964, 1e-6);  // the normal distribution's
}

TEST(StudentT, ExceedsItsQuantileInOneOfTwentyDrawsOnEitherSide) {
  for (const double freedom : {1.0, 2.5, 10.0, 1e4}) {
    EXPECT_NEAR(two_sided_p(t95(freedom), freedom), 0.05, 1e-12);
    EXPECT_NEAR(two_sided_p(-t95(freedom), freedom), 0.05, 1e-12);
  }
  EXPECT_DOUBLE_EQ(two_sided_p(0, 3), 1);
}

}  // namespace
}  // namespace slosh::sample_moments_test

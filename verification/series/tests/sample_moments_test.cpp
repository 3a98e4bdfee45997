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

}  // namespace
}  // namespace slosh::sample_moments_test

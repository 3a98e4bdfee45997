#include "verification/assessment/across_runs/solution_distances.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace slosh::solution_distances_test {
namespace {

TEST(Outlier, IsTheSolutionFarFromAllOthersWithoutTheDistancesThatAreNaN) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(outlier({{0, 0.02, 0.30}, {0.02, 0, 0.31}, {0.30, 0.31, 0}}), 2U);
  EXPECT_EQ(outlier({{0, 0.1, 0.1}, {0.1, 0, 0.1}, {0.1, 0.1, 0}}), std::nullopt);
  EXPECT_EQ(outlier({{0, 0.1, 0.15}, {0.1, 0, 0.15}, {0.15, 0.15, 0}}), std::nullopt);
  EXPECT_EQ(outlier({{0, nan, nan}, {nan, 0, nan}, {nan, nan, 0}}), std::nullopt);
  EXPECT_EQ(outlier({{0, 0.1, 1, nan}, {0.1, 0, 1, nan}, {1, 1, 0, nan}, {nan, nan, nan, 0}}), 2U);
}

}  // namespace
}  // namespace slosh::solution_distances_test

// Against printed tables (Fisher & Yates) and the normal distribution.
#include <gtest/gtest.h>

#include "verification/series/sample_moments.hpp"

namespace slosh::student_t_test {
namespace {

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
}  // namespace slosh::student_t_test

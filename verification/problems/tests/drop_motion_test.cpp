// The exact motion of the drop: invariants, and the periods and the span of its axis that an
// integration by other means gives.
#include "verification/problems/drop_motion.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace slosh::drop_motion_test {
namespace {

TEST(DropMotion, HasTheKnownPeriods) {
  const double known[][2] = {{0.1, 4.4484}, {0.5, 4.5674}, {1, 4.8273}, {1.5, 5.0799}};
  for (const auto& [amplitude, period] : known)
    EXPECT_NEAR(drop_period(amplitude), period, 1e-4) << amplitude;
}

TEST(DropMotion, SpansTheKnownSemiAxis) {
  SemiAxes axes{1, 1, 1};
  double least = 1, most = 1;
  for (int i = 0; i < 1000; ++i) {
    axes = advanced(axes, 0.005);
    least = std::min(least, axes.a);
    most = std::max(most, axes.a);
  }
  EXPECT_NEAR(least, 0.5176, 1e-4);
  EXPECT_NEAR(most, 1.9319, 1e-4);
}

// Energy: kinetic sigma^2 (a^2 + b^2) / 8 and that of the force (a^2 + b^2) / 8.
TEST(DropMotion, KeepsTheAreaAndTheEnergy) {
  const SemiAxes end = advanced({1, 1, 1.5}, 7.3);
  EXPECT_NEAR(end.a * end.b, 1, 1e-10);
  EXPECT_NEAR((end.sigma * end.sigma + 1) * (end.a * end.a + end.b * end.b), 2 * (1.5 * 1.5 + 1),
              1e-9);
}

}  // namespace
}  // namespace slosh::drop_motion_test

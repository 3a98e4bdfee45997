#include "verification/convergence/power_law_line.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "verification/series/time_series.hpp"

namespace slosh::power_law_line_test {
namespace {

TEST(PowerLawLine, OfAnExactLawIsThatLawWithoutABand) {
  const PowerLawLine line = fit_power_law_line({{0.01, 3e-4}, {0.02, 12e-4}, {0.04, 48e-4}});
  EXPECT_NEAR(line.order.value, 2, 1e-12);
  EXPECT_NEAR(line.order.half_width, 0, 1e-6);
  const auto [value, lower, upper] = line.at(0.03);
  EXPECT_NEAR(value, 27e-4, 1e-12);
  EXPECT_NEAR(lower, value, 1e-9);
  EXPECT_NEAR(upper, value, 1e-9);
}

// y = 0, 1, 1, 2 at x = 0, 1, 2, 3: slope 0.6, intercept 0.1, sum of squared residuals 0.2, so that
// s^2 = 0.1, S = 5 and t = 4.302653 of two degrees of freedom.
TEST(PowerLawLine, HasTheBandOfTheTextbookLine) {
  const double e = std::exp(1);
  const PowerLawLine line = fit_power_law_line({{1, 1}, {e, e}, {e * e, e}, {e * e * e, e * e}});
  EXPECT_NEAR(line.order.value, 0.6, 1e-12);
  EXPECT_NEAR(line.order.half_width, 4.302653 * std::sqrt(0.1 / 5), 1e-6);
  const auto [value, lower, upper] = line.at(1);
  const double half = 4.302653 * std::sqrt(0.1 * (1.0 / 4 + 1.5 * 1.5 / 5));
  EXPECT_NEAR(std::log(value), 0.1, 1e-12);
  EXPECT_NEAR(std::log(lower), 0.1 - half, 1e-6);
  EXPECT_NEAR(std::log(upper), 0.1 + half, 1e-6);
}

TEST(PowerLawLine, RefusesWhatHasNoLogarithmOrNoSpread) {
  EXPECT_THROW(fit_power_law_line({{0.01, 1}, {0.02, 2}}), ComparisonError);
  for (const double bad : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(fit_power_law_line({{0.01, 1}, {0.02, bad}, {0.04, 4}}), ComparisonError) << bad;
    EXPECT_THROW(fit_power_law_line({{0.01, 1}, {bad, 2}, {0.04, 4}}), ComparisonError) << bad;
  }
  EXPECT_THROW(fit_power_law_line({{0.01, 1}, {0.01, 2}, {0.01, 4}}), ComparisonError);
}

}  // namespace
}  // namespace slosh::power_law_line_test

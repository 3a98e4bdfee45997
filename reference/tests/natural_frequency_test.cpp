#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "reference/linear_surge.hpp"
#include "reference/tests/li_tank.hpp"

namespace slosh::reference::natural_frequency_test {
namespace {

// Published tanks of Li et al. 2010, SPHERIC benchmark 10, and Akyildiz & Unal 2006. Frequencies
// are in rad/s, periods in s.
TEST(NaturalFrequency, GivesTheFirstModeOfThePublishedTanks) {
  const auto omega = [](double length, double depth) {
    return natural_frequency({length, depth, 9.81, 1000}, 1);
  };
  const auto period = [&](double length, double depth) {
    return 2 * std::numbers::pi / omega(length, depth);
  };
  EXPECT_NEAR(omega(1.0, 0.35), 4.96646, 5e-6);
  EXPECT_NEAR(omega(0.9, 0.093), 3.27746, 5e-6);
  EXPECT_NEAR(omega(0.92, 0.465), 5.55095, 5e-6);
  EXPECT_NEAR(period(1.0, 0.35), 1.26512, 5e-6);
  EXPECT_NEAR(period(0.9, 0.093), 1.91709, 5e-6);
  EXPECT_NEAR(period(0.92, 0.465), 1.13191, 5e-6);
}

TEST(NaturalFrequency, ApproachesDeepAndShallowWater) {
  const double k = std::numbers::pi;
  EXPECT_NEAR(natural_frequency({1, 50, 9.81, 1000}, 1), std::sqrt(9.81 * k), 1e-12);
  EXPECT_NEAR(natural_frequency({1, 1e-5, 9.81, 1000}, 1), k * std::sqrt(9.81 * 1e-5), 1e-10);
}

// Air of 1.2 kg/m3 over 0.65 m lowers the first mode of Li's tank by 0.11 %.
TEST(NaturalFrequency, IsLoweredByTheAirAbove) {
  const double alone = natural_frequency(li_tank, 1);
  EXPECT_NEAR(natural_frequency(li_tank, {.density = 1.2, .height = 0.65}, 1) / alone - 1, -0.0011,
              5e-6);
  EXPECT_DOUBLE_EQ(natural_frequency(li_tank, {.density = 0, .height = 0.65}, 1), alone);
}

TEST(NaturalFrequency, RefusesWhatIsImpossible) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(natural_frequency({0, 0.35, 9.81, 1000}, 1), std::invalid_argument);
  EXPECT_THROW(natural_frequency({1, nan, 9.81, 1000}, 1), std::invalid_argument);
  EXPECT_THROW(natural_frequency({1, 0.35, -9.81, 1000}, 1), std::invalid_argument);
  EXPECT_THROW(natural_frequency(li_tank, 0), std::invalid_argument);
  EXPECT_THROW(natural_frequency(li_tank, {.density = 1000, .height = 0.65}, 1),
               std::invalid_argument);
  EXPECT_THROW(natural_frequency(li_tank, {.density = 1.2, .height = nan}, 1),
               std::invalid_argument);
}

}  // namespace
}  // namespace slosh::reference::natural_frequency_test

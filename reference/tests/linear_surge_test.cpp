#include "reference/linear_surge.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

#include "reference/tests/paper_tanks.hpp"

namespace slosh::reference::linear_surge_test {
namespace {

// With this many modes the published values are reproduced to their last printed digit. The
// converged series (20000 modes) differs by 0.005 mm for the start in the earth's frame, and not at
// all for that in the tank's.
constexpr int table_modes = 800;
constexpr double millimetre = 1e-3;

// 0 to 12 s.
std::vector<double> twelve_seconds(int samples_per_second) {
  std::vector<double> times;
  for (int i = 0; i <= 12 * samples_per_second; ++i) {
    times.push_back(static_cast<double>(i) / samples_per_second);
  }
  return times;
}

struct Row {
  Start start;
  double max, max_time, min, min_time;  // [mm], [s]
  double values[7];                     // [mm]
};
constexpr double table_times[] = {1, 2, 3, 5, 8, 10, 12};
constexpr Row table[] = {{Start::earth,
                          9.0815,
                          9.731,
                          -9.3608,
                          2.794,
                          {8.80998, 3.41289, -6.10907, 5.57969, -7.88520, 4.72607, -3.02650}},
                         {Start::tank,
                          2.7682,
                          0.988,
                          -2.7682,
                          11.702,
                          {2.76672, 0.66208, -2.53395, 2.19668, -1.96292, 1.99709, -1.97869}}};

TEST(LinearSurge, GivesTheTableOfPublishedValues) {
  for (const Row& row : table) {
    const LinearSurge surge(li_tank, row.start, li_surge, table_modes);
    const auto values = surge.elevation(li_gauge, table_times);
    for (std::size_t i = 0; i < values.size(); ++i) {
      EXPECT_NEAR(values[i], row.values[i] * millimetre, 1e-8) << table_times[i] << " s";
      EXPECT_EQ(values[i], surge.elevation(li_gauge, table_times[i]));
    }
  }
}

TEST(LinearSurge, GivesTheExtremesOfTwelveSeconds) {
  const auto times = twelve_seconds(1000);
  for (const Row& row : table) {
    const auto eta =
        LinearSurge(li_tank, row.start, li_surge, table_modes).elevation(li_gauge, times);
    const auto [lowest, highest] = std::minmax_element(eta.begin(), eta.end());
    EXPECT_NEAR(*highest, row.max * millimetre, 1e-7);
    EXPECT_NEAR(*lowest, row.min * millimetre, 1e-7);
    EXPECT_NEAR(times[highest - eta.begin()], row.max_time, 0.0011);
    EXPECT_NEAR(times[lowest - eta.begin()], row.min_time, 0.0011);
  }
}

double worst_difference(Start start, int modes, int more_modes) {
  const auto times = twelve_seconds(100);
  const auto coarse = LinearSurge(li_tank, start, li_surge, modes).elevation(li_gauge, times);
  const auto fine = LinearSurge(li_tank, start, li_surge, more_modes).elevation(li_gauge, times);
  double worst = 0;
  for (std::size_t i = 0; i < times.size(); ++i) {
    worst = std::max(worst, std::abs(coarse[i] - fine[i]));
  }
  return worst;
}

TEST(LinearSurge, ConvergesWithTheNumberOfModes) {
  EXPECT_NEAR(worst_difference(Start::earth, 10, 200), 0.42 * millimetre, 0.005 * millimetre);
  EXPECT_NEAR(worst_difference(Start::earth, 50, 200), 0.11 * millimetre, 0.005 * millimetre);
  EXPECT_LT(worst_difference(Start::earth, 500, 2000), 0.02 * millimetre);
  EXPECT_LT(worst_difference(Start::tank, 100, 2000), 1e-7);
}

TEST(LinearSurge, StartsAtRestInTheFrameThatIsNamed) {
  const double set_off = li_surge.amplitude * li_surge.angular_frequency;
  const LinearSurge earth(li_tank, Start::earth, li_surge, 1000);
  const LinearSurge tank(li_tank, Start::tank, li_surge, 1000);
  EXPECT_EQ(earth.elevation(li_gauge, 0), 0);
  EXPECT_EQ(tank.elevation(li_gauge, 0), 0);
  // On the surface the impulse of the walls makes no pressure, so that the liquid there stays at
  // rest: its velocity relative to the tank is minus the tank's, but for the ripple of the
  // truncated series.
  EXPECT_NEAR(earth.velocity(0.2, 0, 0).x, -set_off, 1e-3 * set_off);
  EXPECT_EQ(tank.velocity(0.2, -0.1, 0).x, 0);
  EXPECT_EQ(tank.velocity(0.2, -0.1, 0).z, 0);
}

TEST(LinearSurge, TakesASampledMotionAsTheClosedFormOfAnyPhase) {
  for (const Start start : {Start::earth, Start::tank})
    for (const double phase : {0.0, 1.3, std::numbers::pi}) {
      SineSurge sine = li_surge;
      sine.phase = phase;
      const LinearSurge closed(li_tank, start, sine, 500);
      const LinearSurge any(li_tank, start, sampled(sine, 12, 2e-3), 500);
      for (const double t : {0.0, 0.3337, 4.0, 12.0}) {
        EXPECT_NEAR(any.elevation(li_gauge, t), closed.elevation(li_gauge, t), 1e-8);
        EXPECT_NEAR(any.pressure(0.5, -0.1, t), closed.pressure(0.5, -0.1, t), 1e-3);
        EXPECT_NEAR(any.horizontal_force(t), closed.horizontal_force(t), 1e-3);
      }
    }
}

TEST(LinearSurge, NoticesAWrongGravity) {
  Tank wrong = li_tank;
  wrong.gravity = 9.0;
  for (const Row& row : table) {
    const LinearSurge surge(wrong, row.start, li_surge, table_modes);
    for (std::size_t i = 0; i < std::size(table_times); ++i) {
      EXPECT_GT(std::abs(surge.elevation(li_gauge, table_times[i]) - row.values[i] * millimetre),
                1e-6);
    }
  }
}

TEST(LinearSurge, LagsUnderAirByTheTwoLayerTheory) {
  const Gas air{.density = 1.2, .height = 0.65};
  const double omega = natural_frequency(li_tank, air, 1);
  const LinearSurge resonant(li_tank, air, Start::tank, SineSurge{0.001, omega}, 1);
  // At its own two-layer frequency the mode grows without bound: the envelope is linear in time.
  const double period = 2 * std::numbers::pi / omega;
  EXPECT_NEAR(resonant.elevation(0.5, 20 * period) / resonant.elevation(0.5, 10 * period), 2, 1e-9);
  const LinearSurge empty(li_tank, Gas{0, 0.65}, Start::earth, li_surge, 50);
  EXPECT_NEAR(empty.elevation(li_gauge, 9),
              LinearSurge(li_tank, Start::earth, li_surge, 50).elevation(li_gauge, 9), 1e-14);
}

TEST(LinearSurge, RefusesWhatLiesOutside) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const LinearSurge surge(li_tank, Start::earth, sampled(li_surge, 2, 0.01), 5);
  EXPECT_NO_THROW(surge.elevation(0.5, 2 + 1e-12));
  EXPECT_THROW(surge.elevation(0.51, 1), std::invalid_argument);
  EXPECT_THROW(surge.elevation(0.4, 2.1), std::invalid_argument);
  EXPECT_THROW(surge.elevation(0.4, -0.1), std::invalid_argument);
  EXPECT_THROW(surge.elevation(0.4, nan), std::invalid_argument);
  EXPECT_THROW(surge.velocity(0.4, 0.01, 1), std::invalid_argument);
  EXPECT_THROW(surge.pressure(0.4, -0.36, 1), std::invalid_argument);
  EXPECT_THROW(LinearSurge(li_tank, Start::earth, li_surge, 0), std::invalid_argument);
  EXPECT_THROW(LinearSurge(li_tank, Start::earth, SineSurge{0.02, 0}, 5), std::invalid_argument);
  EXPECT_THROW(LinearSurge(li_tank, Start::earth, SineSurge{nan, 1}, 5), std::invalid_argument);
}

TEST(LinearSurge, NamesTheArgumentThatItRefuses) {
  try {
    LinearSurge(li_tank, Start::earth, li_surge, 5).elevation(0.6, 1);
    FAIL() << "a gauge outside the tank was accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(),
                 "LinearSurge: x = 0.6, expected a position within 0.5 m of the tank's centre");
  }
}

// The series of Li et al. 2010 (eqs 16-20, after Faltinsen 1978) as printed, where A is not
// defined. For X = b sin(omega t) it equals ours with A = -b omega, and minus ours with A = +b
// omega:
//   K_n = omega A/C_n 2/a (-1)^n/lambda_n^2,    C_n = cosh(lambda_n h),
//   B_n = omega K_n/(omega_n^2 - omega^2),      A_n = -B_n - K_n/omega,
//   eta = -1/g {A omega x sin(omega t) + sum sin(lambda_n x) C_n
//               [A_n omega_n sin(omega_n t) + B_n omega sin(omega t)]}.
// C_n is cancelled against the one in K_n, as it overflows from the 323rd mode on.

double printed_elevation(double A, double x, double t, int modes) {
  const double g = li_tank.gravity, h = li_tank.fill_depth, a = li_tank.length / 2;
  const double w = li_surge.angular_frequency;
  double sum = A * w * x * std::sin(w * t);
  for (int n = 0; n < modes; ++n) {
    const double lambda = (2 * n + 1) * std::numbers::pi / (2 * a);
    const double wn = std::sqrt(g * lambda * std::tanh(lambda * h));
    const double K = w * A * 2 / a * std::pow(-1, n) / (lambda * lambda);
    const double B = w * K / (wn * wn - w * w);
    const double An = -B - K / w;
    sum += std::sin(lambda * x) * (An * wn * std::sin(wn * t) + B * w * std::sin(w * t));
  }
  return -sum / g;
}

// The printed series contains x itself, while ours expands it; the truncated part is below 1e-8 m.
TEST(Li2010Series, IsOursWithMinusTheVelocityAmplitudeAndItsOppositeWithPlus) {
  const double A = li_surge.amplitude * li_surge.angular_frequency;
  const LinearSurge surge(li_tank, Start::earth, li_surge, 800);
  for (const double t : {0.4, 1.0, 2.794, 5.0, 9.731, 12.0}) {
    const double eta = surge.elevation(li_gauge, t);
    EXPECT_NEAR(printed_elevation(-A, li_gauge, t, 800), eta, 1e-8) << t;
    EXPECT_NEAR(printed_elevation(A, li_gauge, t, 800), -eta, 1e-8) << t;
    EXPECT_GT(std::abs(printed_elevation(A, li_gauge, t, 800) - eta), 1e-4) << t;
  }
}

}  // namespace
}  // namespace slosh::reference::linear_surge_test

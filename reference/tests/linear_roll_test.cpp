#include "reference/linear_roll.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "reference/stokes_joukowski.hpp"
#include "reference/tests/mode_by_odeint.hpp"
#include "reference/tests/paper_tanks.hpp"
#include "reference/tests/quadrature.hpp"

namespace slosh::reference::linear_roll_test {
namespace {

constexpr double wall = zhao_tank.length / 2, pi = std::numbers::pi;
constexpr RollAxis centre{0, zhao_axis_z};

std::vector<double> instants(double from, double to, double step) {
  std::vector<double> times;
  for (int i = 0; from + i * step < to - step / 2; ++i) times.push_back(from + i * step);
  return times;
}

struct Harmonic {
  double mean, sine, cosine;
};

// Fits y = mean + sine sin(omega t) + cosine cos(omega t) by least squares.
Harmonic fit(const std::vector<double>& times, const std::vector<double>& values, double omega) {
  double normal[3][4] = {};
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double basis[3] = {1, std::sin(omega * times[i]), std::cos(omega * times[i])};
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c < 3; ++c) normal[r][c] += basis[r] * basis[c];
      normal[r][3] += basis[r] * values[i];
    }
  }
  for (int p = 0; p < 3; ++p) {
    for (int r = 0; r < 3; ++r) {
      if (r == p) continue;
      const double share = normal[r][p] / normal[p][p];
      for (int c = 0; c < 4; ++c) normal[r][c] -= share * normal[p][c];
    }
  }
  return {normal[0][3] / normal[0][0], normal[1][3] / normal[1][1], normal[2][3] / normal[2][2]};
}

// After a sudden start one tone fitted to the first 10 s gives a mean of 2.894 kPa and an amplitude
// of 0.3235 kPa; the first natural mode, 0.013 kPa, affects both. After a slow ramp only the forced
// wave is left, in opposition to the roll.
TEST(LinearRoll, GivesThePressureOfZhaosTank) {
  const LinearRoll sudden(zhao_tank, Start::earth, sine_roll(centre, 10, 5e-3), 1000);
  const auto first = instants(0, 10, 0.01);
  const Harmonic early = fit(first, sudden.pressure(wall, zhao_gauge_z, first), zhao_frequency);
  EXPECT_NEAR(early.mean, 2894, 0.5);
  EXPECT_NEAR(std::hypot(early.sine, early.cosine), 323.5, 0.05);

  const LinearRoll raised(zhao_tank, Start::earth, ramped_roll(centre, 2 * pi, 12 * pi, 5e-3), 50);
  const auto settled = instants(4 * pi, 12 * pi, pi / 200);
  const Harmonic late = fit(settled, raised.pressure(wall, zhao_gauge_z, settled), zhao_frequency);
  EXPECT_NEAR(late.mean, 2893.95, 0.01);
  EXPECT_NEAR(late.sine, -323.15, 0.01);
  EXPECT_NEAR(late.cosine, 0, 0.01);
}

// Each mode is obtained from the elevation by projection and compared with its equation for eta_n
// with the two forcing terms, where the coefficients S_n are computed by quadrature of Psi(x, 0).
TEST(LinearRoll, SolvesTheModesEquationInTheElevationInTheTank) {
  const std::vector<double> times{0.01, 0.3, 1, 2.7, 5};
  const RollMotion motion = sine_roll({0.1, zhao_axis_z}, 5, 5e-4);
  const StokesJoukowski psi(zhao_tank, motion.axis_x, motion.axis_z);
  const double g = zhao_tank.gravity;
  for (const Start start : {Start::earth, Start::tank}) {
    const LinearRoll roll(zhao_tank, start, motion, 4);
    for (int n = 0; n < 3; ++n) {
      const double lambda = (2 * n + 1) * pi / zhao_tank.length;
      const auto share = [&](auto f) {
        return integral(-wall, wall, 400, [&](double x) { return f(x) * std::sin(lambda * x); }) /
               wall;
      };
      const double line = share([](double x) { return x; });
      const double rigid = share([&](double x) { return psi.potential(x, 0); });
      const double lift = lambda * std::tanh(lambda * zhao_tank.fill_depth);
      const TankMode mode{
          .wave_number = 0,
          .depth_factor = 0,
          .line = 0,
          .coupling = lift,
          .natural_frequency = std::sqrt(g * lift),
          .initial_rate = start == Start::earth ? -lift * rigid * motion.rate(0) : 0};
      const auto forcing = [&](double t) {
        return g * line * motion.angle(t) + rigid * motion.acceleration(t);
      };
      const auto expected = mode_by_odeint(mode, forcing, times);
      for (std::size_t i = 0; i < times.size(); ++i) {
        EXPECT_NEAR(share([&](double x) { return roll.elevation(x, times[i]); }), expected[i][0],
                    2e-8)
            << "mode " << n << " at " << times[i] << " s";
      }
    }
  }
}

// A roll about an axis at a large distance R is a surge: X(t) = R theta for an axis above, -R theta
// for one below.
TEST(LinearRoll, IsASurgeAboutAnAxisFarAway) {
  const AnySurge motion = sampled(li_surge, 5, 5e-3);
  for (const double R : {1e8, -1e8}) {
    const RollMotion far{
        .angle =
            [=](double t) {
              return li_surge.amplitude / R * std::sin(li_surge.angular_frequency * t);
            },
        .rate =
            [=](double t) {
              return motion.initial_velocity / R * std::cos(li_surge.angular_frequency * t);
            },
        .acceleration = [=](double t) { return motion.acceleration(t) / R; },
        .axis_x = 0,
        .axis_z = R,
        .duration = 5,
        .step = 5e-3};
    for (const Start start : {Start::earth, Start::tank}) {
      const LinearSurge surge(li_tank, start, motion, 200);
      const LinearRoll roll(li_tank, start, far, 200);
      for (const double t : {0.0, 0.37, 2.0, 4.9}) {
        EXPECT_NEAR(roll.elevation(li_gauge, t), surge.elevation(li_gauge, t), 1e-9);
        EXPECT_NEAR(roll.pressure(0.5, -0.1, t), surge.pressure(0.5, -0.1, t), 1e-4);
        EXPECT_NEAR(roll.pressure(-0.3, -0.35, t), surge.pressure(-0.3, -0.35, t), 1e-4);
        EXPECT_NEAR(roll.force(t).x, surge.horizontal_force(t), 1e-4);
        EXPECT_NEAR(roll.moment(t) / R, surge.horizontal_force(t), 1e-4);
      }
      EXPECT_GT(std::abs(surge.elevation(li_gauge, 2)), 1e-4);
      EXPECT_GT(std::abs(surge.horizontal_force(2)), 1);
    }
  }
}

// In a slow counter-clockwise roll the liquid stays horizontal: in the tank's frame it falls at the
// right wall, which rises, by x theta. The remainder is of the order of theta''/omega_1^2. A gas
// that is unrealistically heavy halves the first frequency and must not change the level.
RollMotion slow_roll() {
  const double omega = 0.01;
  return {.angle = [=](double t) { return 0.05 * (1 - std::cos(omega * t)); },
          .rate = [=](double t) { return 0.05 * omega * std::sin(omega * t); },
          .acceleration = [=](double t) { return 0.05 * omega * omega * std::cos(omega * t); },
          .axis_x = 0.2,
          .axis_z = -0.3,
          .duration = 200,
          .step = 0.1};
}

TEST(LinearRoll, StaysLevelWhenItIsTurnedSlowly) {
  const RollMotion motion = slow_roll();
  const LinearRoll plain(zhao_tank, Start::earth, motion, 100);
  const LinearRoll under_gas(zhao_tank, {500, 0.155}, Start::earth, motion, 100);
  const double weight = 9810 * 0.92 * 0.465, t = 150, theta = motion.angle(t);
  for (const double x : {-wall, -0.1, 0.3, wall}) {
    EXPECT_NEAR(plain.elevation(x, t), -x * theta, 1e-6);
    EXPECT_NEAR(under_gas.elevation(x, t), -x * theta, 1e-6);
    EXPECT_NEAR(plain.pressure(x, -0.2, t), 9810 * (0.2 - x * theta), 0.01);
  }
  // The weight acts at the liquid's centre, which moves sideways by L^2 theta/(12 h).
  const double lever = -0.2 + theta * (-0.3 + 0.2325) - theta * 0.92 * 0.92 / (12 * 0.465);
  EXPECT_NEAR(plain.force(t).x, -weight * theta, 0.01);
  EXPECT_NEAR(plain.force(t).z, -weight, 0.01);
  EXPECT_NEAR(plain.moment(t), -weight * lever, 0.01);
}

TEST(LinearRoll, StartsLevelInATankThatStandsTilted) {
  RollMotion tilted = sine_roll(centre, 1, 0.1);
  tilted.angle = [](double) { return 0.05; };
  tilted.rate = tilted.acceleration = [](double) { return 0.0; };
  for (const Start start : {Start::earth, Start::tank}) {
    const LinearRoll roll(zhao_tank, start, tilted, 10);
    for (const double t : {0.0, 0.7}) EXPECT_EQ(roll.elevation(0.3, t), -0.3 * 0.05);
  }
}

double worst_difference(const RollMotion& motion, int modes, int more_modes) {
  const auto times = instants(0, 12, 0.01);
  const auto coarse = LinearRoll(zhao_tank, Start::earth, motion, modes).elevation(wall, times);
  const auto fine = LinearRoll(zhao_tank, Start::earth, motion, more_modes).elevation(wall, times);
  double worst = 0;
  for (std::size_t i = 0; i < times.size(); ++i) {
    worst = std::max(worst, std::abs(coarse[i] - fine[i]));
  }
  return worst;
}

TEST(LinearRoll, ConvergesWithTheNumberOfModes) {
  EXPECT_LT(worst_difference(sine_roll(centre, 12, 0.02), 500, 3000), 5e-5);
  EXPECT_LT(worst_difference(ramped_roll(centre, pi, 12, 0.02), 500, 3000), 1e-6);
  const LinearRoll few(zhao_tank, Start::earth, sine_roll(centre, 5, 0.01), 40);
  const LinearRoll many(zhao_tank, Start::earth, sine_roll(centre, 5, 0.01), 1000);
  for (const double t : {0.0, 0.3, 5.0}) {
    EXPECT_NEAR(few.pressure(wall, zhao_gauge_z, t), many.pressure(wall, zhao_gauge_z, t), 1e-9);
  }
}

TEST(LinearRoll, GivesASeriesAsItsSingleValues) {
  const LinearRoll roll(zhao_tank, Start::earth, sine_roll(centre, 2, 0.01), 30);
  const std::vector<double> times{0, 0.4, 1.234, 2};
  const auto elevation = roll.elevation(0.3, times);
  const auto pressure = roll.pressure(0.3, -0.05, times);
  for (std::size_t i = 0; i < times.size(); ++i) {
    EXPECT_EQ(elevation[i], roll.elevation(0.3, times[i]));
    EXPECT_EQ(pressure[i], roll.pressure(0.3, -0.05, times[i]));
  }
}

TEST(LinearRoll, OscillatesUnderAGasByTheTwoLayerTheory) {
  const Gas air{.density = 1.2, .height = 0.155};
  const double omega = natural_frequency(zhao_tank, air, 1);
  const RollMotion resonant{
      .angle = [=](double t) { return 1e-3 * std::sin(omega * t); },
      .rate = [=](double t) { return 1e-3 * omega * std::cos(omega * t); },
      .acceleration = [=](double t) { return -1e-3 * omega * omega * std::sin(omega * t); },
      .axis_x = 0,
      .axis_z = zhao_axis_z,
      .duration = 25,
      .step = 1e-3};
  const LinearRoll roll(zhao_tank, air, Start::tank, resonant, 1);
  // At its own two-layer frequency the mode grows without bound: the envelope is linear in time.
  const double period = 2 * pi / omega;
  EXPECT_NEAR(roll.elevation(wall, 20 * period) / roll.elevation(wall, 10 * period), 2, 1e-4);
  const LinearRoll empty(zhao_tank, Gas{0, 0.155}, Start::earth, resonant, 50);
  const LinearRoll plain(zhao_tank, Start::earth, resonant, 50);
  EXPECT_NEAR(empty.elevation(0.4, 3), plain.elevation(0.4, 3), 1e-14);
  EXPECT_NEAR(empty.moment(3), plain.moment(3), 1e-9);
}

TEST(LinearRoll, RefusesWhatLiesOutside) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const RollMotion motion = sine_roll(centre, 2, 0.01);
  const LinearRoll roll(zhao_tank, Start::earth, motion, 5);
  EXPECT_NO_THROW(roll.elevation(wall, 2 + 1e-12));
  EXPECT_THROW(roll.elevation(0.47, 1), std::invalid_argument);
  EXPECT_THROW(roll.elevation(0.4, 2.1), std::invalid_argument);
  EXPECT_THROW(roll.elevation(0.4, nan), std::invalid_argument);
  EXPECT_THROW(roll.pressure(0.4, 0.01, 1), std::invalid_argument);
  EXPECT_THROW(roll.pressure(0.4, nan, 1), std::invalid_argument);
  EXPECT_THROW(roll.force(-0.1), std::invalid_argument);
  EXPECT_THROW(roll.moment(nan), std::invalid_argument);

  const auto built = [&](auto change, int modes = 5) {
    RollMotion changed = motion;
    change(changed);
    return LinearRoll(zhao_tank, Start::earth, changed, modes);
  };
  const auto none = [=](double) { return nan; };
  EXPECT_NO_THROW(built([](RollMotion&) {}));
  EXPECT_THROW(built([](RollMotion&) {}, 0), std::invalid_argument);
  EXPECT_THROW(built([=](RollMotion& m) { m.axis_x = nan; }), std::invalid_argument);
  EXPECT_THROW(built([=](RollMotion& m) { m.axis_z = nan; }), std::invalid_argument);
  EXPECT_THROW(built([=](RollMotion& m) { m.rate = none; }), std::invalid_argument);
  EXPECT_THROW(built([=](RollMotion& m) { m.acceleration = none; }), std::invalid_argument);
  EXPECT_THROW(built([=](RollMotion& m) { m.angle = nullptr; }), std::invalid_argument);
  EXPECT_THROW(built([=](RollMotion& m) { m.duration = nan; }), std::invalid_argument);
  EXPECT_THROW(built([=](RollMotion& m) { m.step = 3; }), std::invalid_argument);
  EXPECT_THROW(built([=](RollMotion& m) { m.angle = none; }).force(1), std::invalid_argument);
  EXPECT_THROW(LinearRoll(zhao_tank, Gas{1001, 0.155}, Start::earth, motion, 5),
               std::invalid_argument);
}

TEST(LinearRoll, NamesTheArgumentThatItRefuses) {
  try {
    LinearRoll(zhao_tank, Start::earth, sine_roll(centre, 2, 3), 5);
    FAIL() << "a step above the duration was accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(),
                 "LinearRoll: step = 3, expected a time step > 0 s and up to the duration");
  }
}

}  // namespace
}  // namespace slosh::reference::linear_roll_test

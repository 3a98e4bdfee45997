#include "reference/standing_wave.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

#include "reference/linear_surge.hpp"
#include "reference/potential_flow/tank_motion.hpp"
#include "reference/tests/paper_tanks.hpp"
#include "reference/tests/quadrature.hpp"

namespace slosh::reference::standing_wave_test {
namespace {

TEST(StandingWave, StartsAsACosineFromTheLeftWall) {
  for (const int mode : {1, 2, 5}) {
    const StandingWave wave(li_tank, std::nullopt, {mode, 0.01});
    const double k = mode * std::numbers::pi / li_tank.length;
    for (const double from_wall : {0.0, 0.13, 0.5, 1.0})
      EXPECT_NEAR(wave.elevation(from_wall - 0.5, 0), 0.01 * std::cos(k * from_wall), 1e-16);
  }
}

TEST(StandingWave, SwingsWithTheNaturalFrequencyOfItsModeAndWithTheGasOnTop) {
  const Gas air{.density = 1.2, .height = 0.65};
  for (const int mode : {1, 2}) {
    EXPECT_EQ(StandingWave(li_tank, std::nullopt, {mode, 0.01}).angular_frequency(),
              natural_frequency(li_tank, mode));
    EXPECT_EQ(StandingWave(li_tank, air, {mode, 0.01}).angular_frequency(),
              natural_frequency(li_tank, air, mode));
  }
  const StandingWave wave(li_tank, std::nullopt, {1, 0.01});
  const double period = 2 * std::numbers::pi / wave.angular_frequency();
  EXPECT_NEAR(wave.elevation(-0.5, period / 2), -0.01, 1e-15);
  EXPECT_NEAR(wave.elevation(-0.5, 7 * period), 0.01, 1e-14);
}

TEST(StandingWave, HasTheSurfacesPressureUnderItsOwnWeight) {
  const StandingWave wave(li_tank, std::nullopt, {2, 0.01});
  // To first order p = rho g eta on the still surface; far below a short wave the pressure is
  // hydrostatic.
  for (const double x : {-0.5, -0.2, 0.4})
    for (const double t : {0.0, 0.3})
      EXPECT_NEAR(wave.pressure(x, 0, t), 1000 * 9.81 * wave.elevation(x, t), 1e-10);
  const StandingWave ripple(li_tank, std::nullopt, {60, 0.01});
  EXPECT_NEAR(ripple.pressure(-0.5, -0.35, 0), 1000 * 9.81 * 0.35, 1e-9);
}

TEST(StandingWave, PushesTheTankByItsPressureOnTheWalls) {
  for (const int mode : {1, 2, 3}) {
    const StandingWave wave(li_tank, std::nullopt, {mode, 0.01});
    for (const double t : {0.0, 0.4, 1.7}) {
      const double force = integral(-0.35, 0, 200, [&](double z) {
        return wave.pressure(0.5, z, t) - wave.pressure(-0.5, z, t);
      });
      EXPECT_NEAR(wave.horizontal_force(t), force, 1e-6) << mode << " " << t;
    }
  }
}

// Under a gas the force is minus the rate of change of both layers' momentum, which follows from
// their common surface: (rho_w - rho_a) times the integral of x eta_tt. No pressure enters.
TEST(StandingWave, PushesTheTankTogetherWithTheGas) {
  const StandingWave wave(li_tank, Gas{.density = 600, .height = 0.3}, {1, 0.01});
  const double d = 1e-3, t = 0.4;
  const double rate = integral(-0.5, 0.5, 200, [&](double x) {
    return x * (wave.elevation(x, t + d) - 2 * wave.elevation(x, t) + wave.elevation(x, t - d)) /
           (d * d);
  });
  EXPECT_NEAR(wave.horizontal_force(t) / (-400 * rate), 1, 1e-5);
}

// By Euler's equation rho times the velocity's rate is minus the gradient of the pressure less the
// hydrostatic one; at the start the liquid is at rest.
TEST(StandingWave, MovesAsItsPressureAccelerates) {
  const double step = 1e-4;
  for (const int mode : {1, 2}) {
    const StandingWave wave(li_tank, std::nullopt, {mode, 0.01});
    EXPECT_EQ(wave.velocity(0.2, -0.1, 0).x, 0);
    EXPECT_EQ(wave.velocity(0.2, -0.1, 0).z, 0);
    for (const double t : {0.3, 1.1}) {
      const auto p = [&](double x, double z) { return wave.pressure(x, z, t); };
      const auto [late_x, late_z] = wave.velocity(0.2, -0.1, t + step);
      const auto [early_x, early_z] = wave.velocity(0.2, -0.1, t - step);
      EXPECT_NEAR(li_tank.density * (late_x - early_x) / (2 * step),
                  -(p(0.2 + step, -0.1) - p(0.2 - step, -0.1)) / (2 * step), 1e-3);
      EXPECT_NEAR(li_tank.density * (late_z - early_z) / (2 * step),
                  -(p(0.2, -0.1 + step) - p(0.2, -0.1 - step)) / (2 * step) -
                      li_tank.density * li_tank.gravity,
                  1e-3);
      EXPECT_NEAR(wave.velocity(0.1, 0, t).z,
                  (wave.elevation(0.1, t + step) - wave.elevation(0.1, t - step)) / (2 * step),
                  1e-8);
      EXPECT_NEAR(wave.velocity(-0.5, -0.1, t).x, 0, 1e-15);
      EXPECT_NEAR(wave.velocity(0.3, -0.35, t).z, 0, 1e-15);
    }
  }
}

TEST(StandingWave, RefusesWhatIsImpossible) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(StandingWave(li_tank, std::nullopt, {0, 0.01}), std::invalid_argument);
  EXPECT_THROW(StandingWave(li_tank, std::nullopt, {1, nan}), std::invalid_argument);
  EXPECT_THROW(StandingWave({1, -0.35, 9.81, 1000}, std::nullopt, {1, 0.01}),
               std::invalid_argument);
  const StandingWave wave(li_tank, std::nullopt, {1, 0.01});
  EXPECT_THROW(wave.elevation(0.6, 0), std::invalid_argument);
  EXPECT_THROW(wave.elevation(0, -1), std::invalid_argument);
  EXPECT_THROW(wave.pressure(0, 0.1, 0), std::invalid_argument);
  EXPECT_THROW(wave.pressure(0, -0.36, 0), std::invalid_argument);
  EXPECT_THROW(wave.velocity(0, 0.1, 0), std::invalid_argument);
  EXPECT_THROW(wave.horizontal_force(nan), std::invalid_argument);
}

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

// A surge of 0.3 sin(2 t) and a roll of 0.8 sin(t) about (0.1, -0.2).
TankMotion swing() {
  return {.surge_velocity = [](double t) { return 0.6 * std::cos(2 * t); },
          .surge_acceleration = [](double t) { return -1.2 * std::sin(2 * t); },
          .angle = [](double t) { return 0.8 * std::sin(t); },
          .rate = [](double t) { return 0.8 * std::cos(t); },
          .roll_acceleration = [](double t) { return -0.8 * std::sin(t); },
          .axis_x = 0.1,
          .axis_z = -0.2};
}

struct Point {
  double x, z;
};

// Returns the place of a point of the tank in the earth's frame.
Point in_the_earth(double x, double z, double t) {
  const double theta = 0.8 * std::sin(t), dx = x - 0.1, dz = z + 0.2;
  return {0.1 + 0.3 * std::sin(2 * t) + dx * std::cos(theta) - dz * std::sin(theta),
          -0.2 + dx * std::sin(theta) + dz * std::cos(theta)};
}

// The error of the central differences is 2e-9.
TEST(TankMotion, MovesThePointsOfTheTankAlongItsAxes) {
  const double t = 0.7, x = -0.4, z = -0.3, d = 1e-5;
  const TankPlace now = place(swing(), t);
  const Point before = in_the_earth(x, z, t - d), after = in_the_earth(x, z, t + d);
  const double vx = (after.x - before.x) / (2 * d), vz = (after.z - before.z) / (2 * d);
  EXPECT_NEAR(now.velocity.along_x(z), vx * std::cos(now.angle) + vz * std::sin(now.angle), 1e-8);
  EXPECT_NEAR(now.velocity.along_z(x), -vx * std::sin(now.angle) + vz * std::cos(now.angle), 1e-8);
  EXPECT_NEAR(now.height(x, z), in_the_earth(x, z, t).z, 1e-15);
}

TEST(TankMotion, GivesTheRateOfTheVelocityAtPointsFixedInTheTank) {
  const double t = 0.7, x = -0.4, z = -0.3, d = 1e-5;
  const TankPlace now = place(swing(), t), before = place(swing(), t - d),
                  after = place(swing(), t + d);
  EXPECT_NEAR(now.acceleration.along_x(z),
              (after.velocity.along_x(z) - before.velocity.along_x(z)) / (2 * d), 1e-8);
  EXPECT_NEAR(now.acceleration.along_z(x),
              (after.velocity.along_z(x) - before.velocity.along_z(x)) / (2 * d), 1e-8);
}

TEST(TankMotion, StandsStillWithoutFunctions) {
  const TankPlace now = place({}, 3);
  EXPECT_EQ(now.angle, 0);
  EXPECT_EQ(now.velocity.along_x(1), 0);
  EXPECT_EQ(now.acceleration.along_z(1), 0);
  EXPECT_EQ(now.height(0.3, -0.1), -0.1);
}

TEST(TankMotion, RefusesHalfAMotionAndWhatIsNotFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  TankMotion half = swing(), adrift = swing(), lost = swing();
  half.surge_acceleration = nullptr;
  EXPECT_THROW(place(half, 0), std::invalid_argument);
  half = swing();
  half.rate = nullptr;
  EXPECT_THROW(place(half, 0), std::invalid_argument);
  adrift.axis_z = nan;
  EXPECT_THROW(place(adrift, 0), std::invalid_argument);
  lost.rate = [=](double) { return nan; };
  try {
    place(lost, 0.5);
    FAIL() << "a NaN rate was accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "TankMotion: rate at 0.5 s = nan, expected a finite value");
  }
}

}  // namespace
}  // namespace slosh::reference::standing_wave_test

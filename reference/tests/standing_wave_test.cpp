#include "reference/standing_wave.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "reference/tests/li_tank.hpp"
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

}  // namespace
}  // namespace slosh::reference::standing_wave_test

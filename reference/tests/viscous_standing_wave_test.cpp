#include "reference/viscous_standing_wave.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "reference/tests/linear_navier_stokes.hpp"

namespace slosh::reference::viscous_standing_wave_test {
namespace {

constexpr double pi = std::numbers::pi;
// Lengths are in depths and times in sqrt(depth / g), with k = pi and nu = 1 / Re.
constexpr Tank unit_tank{.length = 1, .fill_depth = 1, .gravity = 1, .density = 1};
constexpr InitialWave first_mode{.mode = 1, .amplitude = 0.1};

double inviscid(const Tank& tank, int mode) { return natural_frequency(tank, mode); }

// The roots of the exact dispersion relation as two other programs give them.
TEST(ViscousStandingWave, HasTheKnownDampingAndFrequencyAtFourReynoldsNumbers) {
  struct Known {
    double reynolds, damping, frequency;
  };
  for (const auto& [reynolds, damping, frequency] :
       std::array<Known, 4>{{{50, 0.29665, 1.68177},
                             {250, 0.07055, 1.76093},
                             {500, 0.03652, 1.76623},
                             {2500, 0.00763, 1.76888}}}) {
    const ViscousStandingWave wave(unit_tank, 1 / reynolds, first_mode);
    EXPECT_NEAR(wave.damping(), damping, 6e-6) << reynolds;
    EXPECT_NEAR(wave.angular_frequency(), frequency, 6e-6) << reynolds;
  }
}

TEST(ViscousStandingWave, StartsFromItsHeightAndFromRest) {
  for (const double depth : {0.05, 0.35, 1.0, 10.0})
    for (const int mode : {1, 2, 7}) {
      const Tank tank{.length = 1, .fill_depth = depth, .gravity = 9.81, .density = 1000};
      const double k = mode * pi, omega = inviscid(tank, mode);
      for (const double share : {1.0, 0.3, 1e-2, 1e-4}) {
        const ViscousStandingWave wave(tank, share * omega / (4 * k * k), {mode, 1});
        EXPECT_NEAR(wave.elevation(-0.5, 0), 1, 1e-11) << depth << " " << mode << " " << share;
        // A wave from rest under gravity alone is cos(omega t).
        const double t = 1e-5 / omega;
        EXPECT_NEAR(wave.elevation(-0.5, t), 1 - 0.5e-10, 1e-11) << depth << " " << mode;
      }
    }
}

TEST(ViscousStandingWave, FollowsADirectSolutionOfTheLinearNavierStokesEquations) {
  constexpr double step = 0.005;
  constexpr int steps = 800;
  for (const double reynolds : {50.0, 250.0}) {
    const ViscousStandingWave wave(unit_tank, 1 / reynolds, first_mode);
    const auto heights = height_by_collocation({pi, 1, 1, 1 / reynolds}, 40, step, steps);
    for (int i = 0; i <= steps; i += 20)
      EXPECT_NEAR(wave.elevation(-0.5, i * step) / first_mode.amplitude, heights[i], 1e-6)
          << reynolds << " " << i * step;
  }
}

TEST(ViscousStandingWave, DecaysByLambsLawWhereTheLiquidIsHardlyViscous) {
  const Tank tank{.length = 1, .fill_depth = 0.35, .gravity = 9.81, .density = 1000};
  for (const double nu : {1e-6, 1e-9}) {
    const ViscousStandingWave wave(tank, nu, first_mode);
    const double lamb = 2 * nu * pi * pi, omega = inviscid(tank, 1);
    const double higher_order = std::pow(nu * pi * pi / omega, 1.5) * omega;
    EXPECT_NEAR(wave.damping(), lamb, 3 * higher_order);
    EXPECT_NEAR(wave.angular_frequency(), omega, 3 * higher_order);
  }
}

TEST(ViscousStandingWave, IsTheInviscidWaveWithoutViscosity) {
  const ViscousStandingWave viscous(unit_tank, 1e-11, {2, 0.1});
  const StandingWave inviscid(unit_tank, std::nullopt, {2, 0.1});
  for (const double t : {0.0, 0.7, 3.1, 20.0})
    for (const double x : {-0.5, -0.1, 0.25, 0.5})
      EXPECT_NEAR(viscous.elevation(x, t), inviscid.elevation(x, t), 1e-8) << x << " " << t;
}

TEST(ViscousStandingWave, RefusesWhatIsImpossibleOrTooViscousToSwing) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double most = inviscid(unit_tank, 1) / (4 * pi * pi);
  EXPECT_NO_THROW(ViscousStandingWave(unit_tank, 0.999 * most, first_mode));
  for (const double nu : {0.0, -0.01, nan, 1.001 * most})
    EXPECT_THROW(ViscousStandingWave(unit_tank, nu, first_mode), std::invalid_argument) << nu;
  EXPECT_THROW(ViscousStandingWave(unit_tank, 0.01, {0, 0.1}), std::invalid_argument);
  EXPECT_THROW(ViscousStandingWave(unit_tank, 0.01, {1, nan}), std::invalid_argument);
  const ViscousStandingWave wave(unit_tank, 0.01, first_mode);
  EXPECT_THROW(wave.elevation(0.51, 0), std::invalid_argument);
  EXPECT_THROW(wave.elevation(nan, 0), std::invalid_argument);
  EXPECT_THROW(wave.elevation(0, -0.1), std::invalid_argument);
  EXPECT_THROW(wave.elevation(0, nan), std::invalid_argument);
}

}  // namespace
}  // namespace slosh::reference::viscous_standing_wave_test

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

#include "reference/linear_roll.hpp"
#include "reference/linear_surge.hpp"
#include "reference/tests/linear_navier_stokes.hpp"
#include "reference/tests/paper_tanks.hpp"
#include "reference/tests/two_layer_galerkin.hpp"
#include "reference/viscous_standing_wave.hpp"

namespace slosh::reference::two_layer_test {
namespace {

constexpr Gas gases[] = {{1.2, 0.65}, {600, 0.155}, {870, 0.3}};
constexpr double instants[] = {0.4, 1.3, 2.9};
constexpr int degree = 26;

// What the finite degree and the finite number of modes leave, as shares of the largest value. Set
// off from rest in the earth's frame, both leave high modes near the surface.
struct Left {
  double elevation, pressure, load;
};
Left left(Start start) {
  return start == Start::earth ? Left{0.04, 8e-5, 5e-3} : Left{1.5e-3, 5e-7, 9e-5};
}

struct Largest {
  double value = 0, difference = 0;
  void add(double theory, double galerkin) {
    value = std::max(value, std::abs(galerkin));
    difference = std::max(difference, std::abs(theory - galerkin));
  }
  double share() const { return difference / value; }
};

std::string named(const Gas& gas, Start start) {
  return fmt::format("{} kg/m3, at rest in the {}", gas.density,
                     start == Start::earth ? "earth's frame" : "tank");
}

TEST(TwoLayer, SurgeIsThatOfTwoLayersInContact) {
  const AnySurge any = sampled(li_surge, 3, 1);
  for (const Gas& gas : gases)
    for (const Start start : {Start::earth, Start::tank}) {
      TwoLayerGalerkin galerkin(li_tank, gas, start,
                                {.rolls = false,
                                 .place = [](double) { return 0; },
                                 .rate = [&](double) { return any.initial_velocity; },
                                 .acceleration = any.acceleration},
                                degree);
      const LinearSurge surge(li_tank, gas, start, li_surge, 2000);
      Largest elevation, pressure, force;
      const double depth = 0.2, still = 9810 * depth;
      for (const double t : instants) {
        galerkin.advance(t);
        for (const double x : {-0.4, 0.17, 0.45})
          elevation.add(surge.elevation(x, t), galerkin.elevation(x));
        for (const double x : {-0.5, 0.2, 0.5})
          pressure.add(surge.pressure(x, -depth, t) - still, galerkin.pressure(x, -depth) - still);
        force.add(surge.horizontal_force(t), galerkin.force_x());
      }
      EXPECT_LT(elevation.share(), left(start).elevation) << named(gas, start);
      EXPECT_LT(pressure.share(), left(start).pressure) << named(gas, start);
      EXPECT_LT(force.share(), left(start).load) << named(gas, start);
    }
}

TEST(TwoLayer, RollIsThatOfTwoLayersInContact) {
  const RollMotion motion = sine_roll({0.1, zhao_axis_z}, 3, 5e-4);
  for (const Gas& gas : gases)
    for (const Start start : {Start::earth, Start::tank}) {
      TwoLayerGalerkin galerkin(zhao_tank, gas, start,
                                {.rolls = true,
                                 .place = motion.angle,
                                 .rate = motion.rate,
                                 .acceleration = motion.acceleration,
                                 .axis_x = motion.axis_x,
                                 .axis_z = motion.axis_z},
                                degree);
      const LinearRoll roll(zhao_tank, gas, start, motion, 1000);
      Largest elevation, pressure, force, lift, moment;
      const double depth = 0.25, still = 9810 * depth;
      const double weight =
          9.81 * zhao_tank.length * (1000 * zhao_tank.fill_depth + gas.density * gas.height);
      const double at_rest = weight * motion.axis_x;
      for (const double t : instants) {
        galerkin.advance(t);
        for (const double x : {-0.4, 0.17, 0.45})
          elevation.add(roll.elevation(x, t), galerkin.elevation(x));
        for (const double x : {-0.46, 0.2, 0.46})
          pressure.add(roll.pressure(x, -depth, t) - still, galerkin.pressure(x, -depth) - still);
        force.add(roll.force(t).x, galerkin.force_x());
        lift.add(roll.force(t).z + weight, galerkin.force_z() + weight);
        moment.add(roll.moment(t) - at_rest, galerkin.moment() - at_rest);
      }
      EXPECT_LT(elevation.share(), left(start).elevation) << named(gas, start);
      EXPECT_LT(pressure.share(), left(start).pressure) << named(gas, start);
      EXPECT_LT(force.share(), left(start).load) << named(gas, start);
      EXPECT_LT(lift.share(), 1e-8) << named(gas, start);
      EXPECT_LT(moment.share(), left(start).load) << named(gas, start);
    }
}

// A tank whose acceleration hardly changes tilts the surface by X''/g, whatever lies above it: the
// remainder is of the order of (omega/omega_1)^2. Surges start gently, with X'' = 0.
TEST(TwoLayer, ASteadyAccelerationTiltsTheSurfaceAlikeUnderAnyGas) {
  const AnySurge slow{.initial_velocity = 0,
                      .acceleration = [](double t) { return 0.05 * (1 - std::cos(0.01 * t)); },
                      .duration = 200,
                      .step = 0.1};
  for (const Gas& gas : gases) {
    const LinearSurge surge(li_tank, gas, Start::earth, slow, 300);
    for (const double x : {-0.4, 0.1, 0.3})
      EXPECT_NEAR(surge.elevation(x, 150) / (-x * slow.acceleration(150) / 9.81), 1, 1e-3)
          << gas.density << " " << x;
  }
}

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
}  // namespace slosh::reference::two_layer_test

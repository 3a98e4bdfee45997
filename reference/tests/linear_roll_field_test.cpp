// Pressure, elevation, force and moment of the rolling tank against equations that contain neither
// modes nor a potential: the pressure of the linear Euler equation is harmonic, its normal gradient
// on walls, bottom and surface follows from their acceleration, and it vanishes on the wave. The
// axis is off the centre line.
#include <gtest/gtest.h>

#include <cmath>

#include "reference/linear_roll.hpp"
#include "reference/tests/quadrature.hpp"
#include "reference/tests/zhao_tank.hpp"

namespace slosh::reference::linear_roll_field_test {
namespace {

constexpr double a = zhao_tank.length / 2, h = zhao_tank.fill_depth;
constexpr double g = zhao_tank.gravity, rho = zhao_tank.density;
constexpr double instants[] = {0.9, 3.3, 5.77};
constexpr RollAxis axis{0.25, zhao_axis_z};

const RollMotion& motion() {
  static const RollMotion roll = ramped_roll(axis, 3, 6, 2e-3);
  return roll;
}

const LinearRoll& waves() {
  static const LinearRoll roll(zhao_tank, Start::earth, motion(), 1000);
  return roll;
}

// Returns the derivative along (dx, dz) from a place on the boundary into the liquid, to second
// order in the step.
double inward_slope(const LinearRoll& roll, double x, double z, double dx, double dz, double t) {
  const auto p = [&](int steps) { return roll.pressure(x + steps * dx, z + steps * dz, t); };
  return (-3 * p(0) + 4 * p(1) - p(2)) / (2 * std::hypot(dx, dz));
}

TEST(LinearRollField, HasAHarmonicPressure) {
  const double d = 1e-3;
  for (const double t : instants) {
    for (const auto& [x, z] : {std::pair{0.1, -0.1}, {-0.4, -0.3}, {0.44, -0.05}}) {
      const auto p = [&, x = x, z = z](double dx, double dz) {
        return waves().pressure(x + dx, z + dz, t);
      };
      const double curvature = (p(d, 0) + p(-d, 0) - 2 * p(0, 0)) / (d * d);
      EXPECT_GT(std::abs(curvature), 0.1);
      EXPECT_NEAR(curvature + (p(0, d) + p(0, -d) - 2 * p(0, 0)) / (d * d), 0, 0.02);
    }
  }
}

// To first order, in the tank's axes, p_x = -rho (acceleration along x + g theta) and p_z = -rho
// (acceleration along z + g).
TEST(LinearRollField, AcceleratesWithTheWallsAndTheBottom) {
  const double d = 1e-4;
  for (const double t : instants) {
    const double theta = motion().angle(t), turning = motion().acceleration(t);
    for (const double z : {-0.03, -0.2, -0.44}) {
      const double p_x = -rho * (-turning * (z - axis.z) + g * theta);
      EXPECT_NEAR(-inward_slope(waves(), a, z, -d, 0, t), p_x, 0.01);
      EXPECT_NEAR(inward_slope(waves(), -a, z, d, 0, t), p_x, 0.01);
    }
    for (const double x : {-0.44, -0.1, 0.4}) {
      EXPECT_NEAR(inward_slope(waves(), x, -h, 0, d, t), -rho * (turning * (x - axis.x) + g), 0.01);
    }
  }
}

TEST(LinearRollField, AcceleratesWithTheSurfaceAndHasNoPressureOnTheWave) {
  const double d = 1e-4, step = 5e-3;
  for (const double t : instants) {
    for (const double x : {-0.4, -0.1, 0.0, 0.37}) {
      const double rise = (waves().elevation(x, t + step) - 2 * waves().elevation(x, t) +
                           waves().elevation(x, t - step)) /
                          (step * step);
      EXPECT_NEAR(-inward_slope(waves(), x, 0, 0, -d, t),
                  -rho * (motion().acceleration(t) * (x - axis.x) + rise + g), 0.5)
          << x << " " << t;
    }
    for (const double x : {-a, -0.3, 0.0, 0.4, a}) {
      EXPECT_NEAR(waves().pressure(x, 0, t), rho * g * waves().elevation(x, t), 0.01);
    }
  }
}

// The velocity in the earth's frame, along the tank's axes to first order, changes as the pressure
// and the tilt of gravity accelerate it. The walls, the bottom and the wave move with the liquid.
TEST(LinearRollField, MovesAsThePressureAccelerates) {
  const double d = 1e-4, step = 4e-3;
  const auto of_tank = [&](double x, double z, double t) {
    return std::pair{-motion().rate(t) * (z - axis.z), motion().rate(t) * (x - axis.x)};
  };
  const auto velocity = [&](double x, double z, double t) {
    const auto [u, w] = waves().velocity(x, z, t);
    const auto [tank_u, tank_w] = of_tank(x, z, t);
    return std::pair{u + tank_u, w + tank_w};
  };
  for (const double t : instants) {
    for (const auto& [x, z] : {std::pair{0.1, -0.1}, {-0.4, -0.3}, {0.44, -0.05}}) {
      const auto late = velocity(x, z, t + step), early = velocity(x, z, t - step);
      const double p_x = (waves().pressure(x + d, z, t) - waves().pressure(x - d, z, t)) / (2 * d);
      const double p_z = (waves().pressure(x, z + d, t) - waves().pressure(x, z - d, t)) / (2 * d);
      EXPECT_NEAR(rho * (late.first - early.first) / (2 * step), -p_x - rho * g * motion().angle(t),
                  0.5)
          << x << " " << z << " " << t;
      EXPECT_NEAR(rho * (late.second - early.second) / (2 * step), -p_z - rho * g, 0.5)
          << x << " " << z << " " << t;
    }
    EXPECT_GT(std::abs(waves().velocity(0.1, -0.1, t).x), 1e-3);
    for (const double z : {-0.03, -0.2, -0.44}) {
      EXPECT_NEAR(waves().velocity(a, z, t).x, 0, 1e-12);
      EXPECT_NEAR(waves().velocity(-a, z, t).x, 0, 1e-12);
    }
    for (const double x : {-0.44, -0.1, 0.4}) {
      EXPECT_NEAR(waves().velocity(x, -h, t).z, 0, 1e-5);
      EXPECT_NEAR(waves().velocity(x, 0, t).z,
                  (waves().elevation(x, t + step) - waves().elevation(x, t - step)) / (2 * step),
                  1e-3);
    }
  }
}

// Integrates over the walls and the bottom up to the still surface. z = -h s^2 makes the points
// dense near the surface, where the high modes are.
TEST(LinearRollField, PushesAndTurnsTheTankAsTheWallPressuresDo) {
  const LinearRoll sudden(zhao_tank, Start::earth, sine_roll(axis, 6, 1e-2), 200);
  const LinearRoll still(zhao_tank, Start::tank, sine_roll(axis, 6, 1e-2), 200);
  for (const LinearRoll* roll : {&waves(), &sudden, &still}) {
    for (const double t : instants) {
      const auto on_walls = [&](auto lever) {
        return integral(0, 1, 200, [&](double s) {
          const double z = -h * s * s;
          return lever(z) * (roll->pressure(a, z, t) - roll->pressure(-a, z, t)) * 2 * h * s;
        });
      };
      const auto on_bottom = [&](auto lever) {
        return integral(-a, a, 400, [&](double x) { return lever(x) * roll->pressure(x, -h, t); });
      };
      const double force_x = on_walls([](double) { return 1; });
      const double force_z = -on_bottom([](double) { return 1; });
      const double moment = -on_walls([](double z) { return z - axis.z; }) -
                            on_bottom([](double x) { return x - axis.x; });
      EXPECT_GT(std::abs(force_x), 10);
      EXPECT_NEAR(roll->force(t).x, force_x, 0.02);
      EXPECT_NEAR(roll->force(t).z, force_z, 0.02);
      EXPECT_NEAR(roll->moment(t), moment, 0.02);
    }
  }
}

// In the earth's frame the liquid's centre of mass obeys Newton's law. To first order its x in the
// tank is the integral of x eta over L h. No pressure enters.
TEST(LinearRollField, BalancesTheLiquidsMomentum) {
  const double d = 5e-3, mass = rho * 2 * a * h;
  const LinearRoll roll(zhao_tank, Start::earth, sine_roll(axis, 6, 1e-3), 40);
  const auto centre = [&](double t) {
    return integral(-a, a, 1000, [&](double x) { return x * roll.elevation(x, t); }) / (2 * a * h);
  };
  for (const double t : instants) {
    const double turning =
        -zhao_frequency * zhao_frequency * zhao_amplitude * std::sin(zhao_frequency * t);
    const double theta = zhao_amplitude * std::sin(zhao_frequency * t);
    const double sideways =
        turning * (h / 2 + axis.z) + (centre(t + d) - 2 * centre(t) + centre(t - d)) / (d * d);
    EXPECT_NEAR(roll.force(t).x, -mass * (sideways + g * theta), 0.2);
    EXPECT_NEAR(roll.force(t).z, -mass * (g - turning * axis.x), 1e-2);
  }
}

}  // namespace
}  // namespace slosh::reference::linear_roll_field_test

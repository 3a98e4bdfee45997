#include <gtest/gtest.h>

#include <cmath>

#include "reference/linear_roll.hpp"
#include "reference/linear_surge.hpp"
#include "reference/tests/paper_tanks.hpp"
#include "reference/tests/quadrature.hpp"

namespace slosh::reference::linear_fields_test {
namespace {

constexpr double wall = 0.5, bottom = -0.35, t = 3.3;

const LinearSurge& waves(Start start) {
  static const LinearSurge earth(li_tank, Start::earth, li_surge, 800);
  static const LinearSurge tank(li_tank, Start::tank, li_surge, 800);
  return start == Start::earth ? earth : tank;
}

double tank_acceleration(double time) {
  const double b = li_surge.amplitude, omega = li_surge.angular_frequency;
  return -b * omega * omega * std::sin(omega * time);
}

constexpr Start starts[] = {Start::earth, Start::tank};

TEST(LinearSurgeField, IsFreeOfDivergenceAndOfRotation) {
  const double d = 1e-4;
  for (const Start start : starts) {
    const auto at = [&](double x, double z) { return waves(start).velocity(x, z, t); };
    for (const auto& [x, z] : {std::pair{0.1, -0.1}, {-0.37, -0.2}, {0.45, -0.05}}) {
      const double u_x = (at(x + d, z).x - at(x - d, z).x) / (2 * d);
      const double u_z = (at(x, z + d).x - at(x, z - d).x) / (2 * d);
      const double w_x = (at(x + d, z).z - at(x - d, z).z) / (2 * d);
      const double w_z = (at(x, z + d).z - at(x, z - d).z) / (2 * d);
      EXPECT_GT(std::abs(u_x), 1e-3);
      EXPECT_NEAR(u_x + w_z, 0, 1e-6);
      EXPECT_NEAR(u_z - w_x, 0, 1e-6);
    }
  }
}

TEST(LinearSurgeField, CrossesNeitherTheWallsNorTheBottom) {
  for (const Start start : starts) {
    for (const double z : {-0.01, -0.1, -0.3}) {
      EXPECT_NEAR(waves(start).velocity(wall, z, t).x, 0, 1e-12);
      EXPECT_NEAR(waves(start).velocity(-wall, z, t).x, 0, 1e-12);
    }
    for (const double x : {-0.4, 0.1, 0.5}) {
      EXPECT_NEAR(waves(start).velocity(x, bottom, t).z, 0, 1e-15);
    }
  }
}

TEST(LinearSurgeField, CarriesTheSurfaceWithIt) {
  const double d = 1e-5;
  const auto& surge = waves(Start::tank);
  for (const double x : {-0.4, 0.1, 0.45}) {
    EXPECT_NEAR(surge.velocity(x, 0, t).z,
                (surge.elevation(x, t + d) - surge.elevation(x, t - d)) / (2 * d), 1e-7);
  }
}

// The linear Euler equations in the tank's frame: u_t = -p_x/rho - X'', w_t = -p_z/rho - g.
TEST(LinearSurgeField, ObeysTheEquationOfMotionInTheTanksFrame) {
  const double d = 1e-4, rho = li_tank.density;
  for (const Start start : starts) {
    const auto& surge = waves(start);
    for (const auto& [x, z] : {std::pair{0.1, -0.1}, {-0.37, -0.2}, {0.45, -0.05}}) {
      const auto before = surge.velocity(x, z, t - d), after = surge.velocity(x, z, t + d);
      const double p_x = (surge.pressure(x + d, z, t) - surge.pressure(x - d, z, t)) / (2 * d);
      const double p_z = (surge.pressure(x, z + d, t) - surge.pressure(x, z - d, t)) / (2 * d);
      EXPECT_NEAR((after.x - before.x) / (2 * d), -p_x / rho - tank_acceleration(t), 1e-5);
      EXPECT_NEAR((after.z - before.z) / (2 * d), -p_z / rho - li_tank.gravity, 1e-5);
    }
  }
}

// The linear condition p(x, 0) = rho g eta means that the pressure vanishes on the wave. Both sides
// are separate sums. They differ by the elevation's truncated part of X'' x, which is at most X''
// L/(pi^2 modes) and largest at the wall.
TEST(LinearSurgeField, HasNoPressureOnTheWave) {
  const double tail = 1000 * li_surge.amplitude * li_surge.angular_frequency *
                      li_surge.angular_frequency / (9.8696 * 800);
  for (const Start start : starts) {
    for (const double x : {-0.5, -0.3, 0.0, 0.45, 0.5}) {
      EXPECT_NEAR(waves(start).pressure(x, 0, t), 9810 * waves(start).elevation(x, t), 1.01 * tail);
    }
  }
}

TEST(LinearSurgeField, IsHydrostaticBeforeTheTankMoves) {
  const LinearSurge still(li_tank, Start::tank, SineSurge{0, 1}, 10);
  EXPECT_NEAR(still.pressure(0.5, -0.2, 1), 9810 * 0.2, 1e-9);
  EXPECT_EQ(still.horizontal_force(1), 0);
}

TEST(LinearSurgeField, PushesTheTankAsTheWallPressuresDo) {
  for (const Start start : starts) {
    const auto& surge = waves(start);
    // The substitution z = -h + h s (2 - s) makes the points dense near the surface, where the high
    // modes are.
    const double force = integral(0, 1, 400, [&](double s) {
      const double z = bottom * (1 - s) * (1 - s);
      return (surge.pressure(wall, z, t) - surge.pressure(-wall, z, t)) * -2 * bottom * (1 - s);
    });
    EXPECT_GT(std::abs(surge.horizontal_force(t)), 1);
    EXPECT_NEAR(force, surge.horizontal_force(t), 1e-2);
  }
}

// By Newton's law the force on the tank is minus the mass times the acceleration of the liquid's
// centre of mass in the earth's frame, which is X'' plus that of the centre in the tank, the
// integral of x eta over L h. No pressure enters.
TEST(LinearSurgeField, BalancesTheLiquidsMomentum) {
  const double d = 2e-3, mass = li_tank.density * li_tank.length * li_tank.fill_depth;
  const LinearSurge surge(li_tank, Start::earth, li_surge, 40);
  const auto centre = [&](double time) {
    return integral(-wall, wall, 2000, [&](double x) { return x * surge.elevation(x, time); }) /
           (li_tank.length * li_tank.fill_depth);
  };
  for (const double time : {0.7, 3.3, 9.1}) {
    const double acceleration = tank_acceleration(time) +
                                (centre(time + d) - 2 * centre(time) + centre(time - d)) / (d * d);
    EXPECT_NEAR(surge.horizontal_force(time) / (-mass * acceleration), 1, 1e-3);
  }
}

// Pressure, elevation, force and moment of the rolling tank against equations that contain neither
// modes nor a potential: the pressure of the linear Euler equation is harmonic, its normal gradient
// on walls, bottom and surface follows from their acceleration, and it vanishes on the wave. The
// axis is off the centre line.

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
}  // namespace slosh::reference::linear_fields_test

// Velocity, pressure and force of the surging tank against the equations that they must satisfy.
#include <gtest/gtest.h>

#include <cmath>

#include "reference/linear_surge.hpp"
#include "reference/tests/li_tank.hpp"
#include "reference/tests/quadrature.hpp"

namespace slosh::reference::linear_surge_field_test {
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

}  // namespace
}  // namespace slosh::reference::linear_surge_field_test

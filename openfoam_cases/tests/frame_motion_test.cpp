#include "openfoam_cases/frame_motion.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "openfoam_cases/tests/motions.hpp"
#include "openfoam_cases/tests/small_tank.hpp"

namespace slosh::openfoam::frame_motion_test {
namespace {

using Vector = std::array<double, 3>;

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// Surge and roll have a phase each, so that no term is zero at a round time.
SloshingTank moving_tank() {
  SloshingTank tank = small_tank();
  tank.velocity = [](double t) { return 0.6 * std::cos(2 * t + 0.4); };
  tank.acceleration = [](double t) { return -1.2 * std::sin(2 * t + 0.4); };
  tank.roll = {.angle = [](double t) { return 0.5 * std::sin(3 * t + 0.7); },
               .rate = [](double t) { return 1.5 * std::cos(3 * t + 0.7); },
               .acceleration = [](double t) { return -4.5 * std::sin(3 * t + 0.7); },
               .axis_x = 0.3,
               .axis_z = -0.2,
               .initial_relative_rate = 0};
  return tank;
}

// Returns the place of the tank's point (x, z), from the axis, in the earth's frame.
Vector place(const SloshingTank& tank, double x, double z, double time) {
  const double angle = tank.roll->angle(time);
  return {0.3 * std::sin(2 * time + 0.4) + x * std::cos(angle) - z * std::sin(angle), 0,
          x * std::sin(angle) + z * std::cos(angle)};
}

Vector into_tank(double angle, const Vector& v) {
  return {v[0] * std::cos(angle) + v[2] * std::sin(angle), 0,
          -v[0] * std::sin(angle) + v[2] * std::cos(angle)};
}

// A body at rest in the tank has the effective gravity g less the acceleration of its place. In the
// solver's terms this is g0 - a - Omega x (Omega x r) - dOmega/dt x r, computed here with vectors
// in three dimensions as the solver does. It must agree to 1e-7 with the second derivative of the
// path in the earth's frame.
TEST(FrameMotion, IsTheAccelerationOfEveryPointOfTheTank) {
  const SloshingTank tank = moving_tank();
  const double step = 1e-4;
  for (const double time : {0.0, 0.2, 0.55, 1.3}) {
    const FrameMotion motion = frame_motion(tank, time);
    const Vector omega{0, motion.omega_y, 0}, derivative{0, motion.omega_y_derivative, 0};
    for (const Vector& r : {Vector{0, 0, 0}, Vector{0.4, 0, 0}, Vector{-0.2, 0, 1.1}}) {
      const Vector before = place(tank, r[0], r[2], time - step);
      const Vector now = place(tank, r[0], r[2], time);
      const Vector after = place(tank, r[0], r[2], time + step);
      Vector felt{0, 0, -tank.gravity};
      for (const int i : {0, 2}) felt[i] -= (after[i] - 2 * now[i] + before[i]) / (step * step);
      const Vector expected = into_tank(tank.roll->angle(time), felt);
      const Vector centrifugal = cross(omega, cross(omega, r)), euler = cross(derivative, r);
      EXPECT_NEAR(-motion.acceleration_x - centrifugal[0] - euler[0], expected[0], 1e-6);
      EXPECT_NEAR(-tank.gravity - motion.acceleration_z - centrifugal[2] - euler[2], expected[2],
                  1e-6);
    }
  }
}

TEST(FrameMotion, OfATankThatDoesNotRollIsItsSurgeAlone) {
  const SloshingTank tank = small_tank();
  const FrameMotion motion = frame_motion(tank, 0.7);
  EXPECT_EQ(motion.acceleration_x, tank.acceleration(0.7));
  EXPECT_EQ(motion.acceleration_z, 0);
  EXPECT_EQ(motion.omega_y, 0);
  EXPECT_EQ(motion.omega_y_derivative, 0);
}

// A liquid at rest in the earth's frame moves relative to the tank with minus the velocity of the
// tank's points.
TEST(FrameMotion, StartsAtRestInTheEarthsFrameAgainstTheTanksOwnPoints) {
  SloshingTank tank = moving_tank();
  tank.initial_relative_velocity = -tank.velocity(0);
  tank.roll->initial_relative_rate = -tank.roll->rate(0);
  const TankMesh mesh(tank);
  const double step = 1e-5;
  for (const Cell cell : {Cell{0, 0}, Cell{19, 3}, Cell{7, 9}}) {
    const double x = mesh.centre_x(cell.column) - 0.3, z = mesh.centre_z(cell.row) + 0.2;
    const Vector before = place(tank, x, z, -step), after = place(tank, x, z, step);
    Vector velocity{};
    for (const int i : {0, 2}) velocity[i] = (after[i] - before[i]) / (2 * step);
    const Vector expected = into_tank(tank.roll->angle(0), velocity);
    const Velocity found = initial_velocity(tank, mesh, cell);
    EXPECT_NEAR(found.x, -expected[0], 1e-8);
    EXPECT_NEAR(found.z, -expected[2], 1e-8);
  }
}

TEST(FrameMotion, RefusesAMotionThatIsNotFinite) {
  SloshingTank tank = moving_tank();
  tank.roll->rate = [](double) { return NAN; };
  EXPECT_EQ(message_of<std::invalid_argument>([&] { frame_motion(tank, 0.25); }),
            "OpenFOAM tank: roll rate = nan: expected finite at 0.25 s");
}

}  // namespace
}  // namespace slosh::openfoam::frame_motion_test

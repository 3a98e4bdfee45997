#include "reference/potential_flow/tank_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace slosh::reference::tank_motion_test {
namespace {

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
}  // namespace slosh::reference::tank_motion_test

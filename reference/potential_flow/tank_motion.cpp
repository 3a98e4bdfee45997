#include "reference/potential_flow/tank_motion.hpp"

#include <cmath>

#include "reference/require.hpp"

namespace slosh::reference {
namespace {

constexpr auto in_tank_motion = "TankMotion";

double value(const std::function<double(double)>& function, std::string_view name, double t) {
  const double value = function(t);
  require(std::isfinite(value), in_tank_motion, fmt::format("{} at {} s", name, t), value,
          "a finite value");
  return value;
}

}  // namespace

double TankPlace::height(double x, double z) const {
  const double from_axis_x = x - velocity.axis_x, from_axis_z = z - velocity.axis_z;
  return velocity.axis_z + from_axis_x * std::sin(angle) + from_axis_z * std::cos(angle);
}

TankPlace place(const TankMotion& motion, double t) {
  const bool surges = motion.surge_velocity || motion.surge_acceleration;
  const bool rolls = motion.angle || motion.rate || motion.roll_acceleration;
  require(!surges || (motion.surge_velocity && motion.surge_acceleration), in_tank_motion, "surge",
          "an empty function", "velocity and acceleration, or neither");
  require(!rolls || (motion.angle && motion.rate && motion.roll_acceleration), in_tank_motion,
          "roll", "an empty function", "angle, rate and acceleration, or none of them");
  require(std::isfinite(motion.axis_x), in_tank_motion, "axis_x", motion.axis_x,
          "a finite position, m");
  require(std::isfinite(motion.axis_z), in_tank_motion, "axis_z", motion.axis_z,
          "a finite height, m");

  const double angle = rolls ? value(motion.angle, "angle", t) : 0;
  const double rate = rolls ? value(motion.rate, "rate", t) : 0;
  const double surge = surges ? value(motion.surge_velocity, "surge velocity", t) : 0;
  const double push = surges ? value(motion.surge_acceleration, "surge acceleration", t) : 0;
  const double cosine = std::cos(angle), sine = std::sin(angle);
  const double spin = rolls ? value(motion.roll_acceleration, "roll acceleration", t) : 0;
  return {
      .angle = angle,
      .velocity = {surge * cosine, -surge * sine, rate, motion.axis_x, motion.axis_z},
      .acceleration = {push * cosine - surge * rate * sine, -push * sine - surge * rate * cosine,
                       spin, motion.axis_x, motion.axis_z}};
}

}  // namespace slosh::reference

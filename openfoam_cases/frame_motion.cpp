#include "openfoam_cases/frame_motion.hpp"

#include <fmt/format.h>

#include <cmath>

#include "openfoam_cases/errors.hpp"

namespace slosh::openfoam {
namespace {

double finite(const char* key, double value, double time) {
  require(std::isfinite(value), key, value, fmt::format("finite at {} s", time));
  return value;
}

}  // namespace

FrameMotion frame_motion(const SloshingTank& tank, double time) {
  const double surge = finite("acceleration", tank.acceleration(time), time);
  if (!tank.roll) return {surge, 0, 0, 0};
  const double angle = finite("roll angle", tank.roll->angle(time), time);
  const double rate = finite("roll rate", tank.roll->rate(time), time);
  const double angular = finite("roll acceleration", tank.roll->acceleration(time), time);
  const double sine = std::sin(angle), cosine = std::cos(angle);
  return {surge * cosine + tank.gravity * sine,
          -surge * sine + tank.gravity * cosine - tank.gravity, -rate, -angular};
}

Velocity initial_velocity(const SloshingTank& tank, const TankMesh& mesh, Cell cell) {
  if (!tank.roll) return {tank.initial_relative_velocity, 0};
  const double angle = tank.roll->angle(0), rate = tank.roll->initial_relative_rate;
  const Corner centre = mesh.centre(cell);
  const double x = centre.x - mesh.origin_x(), z = centre.z - mesh.origin_z();
  return {tank.initial_relative_velocity * std::cos(angle) - rate * z,
          -tank.initial_relative_velocity * std::sin(angle) + rate * x};
}

}  // namespace slosh::openfoam

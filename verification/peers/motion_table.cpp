#include "verification/peers/motion_table.hpp"

#include <cmath>

#include "verification/case/motion.hpp"
#include "verification/case/motion/motion_times.hpp"

namespace slosh {
namespace {

// Between ten points a sample a straight line errs by (omega dt)^2 / 8 of a sine's acceleration:
// 3e-6 for 5 rad/s sampled at 100 Hz.
constexpr int points_per_sample = 10;

}  // namespace

std::vector<MotionPoint> motion_table(const CaseDefinition& definition) {
  const SurgeMotion surge = surge_motion(definition);
  const std::optional<RollMotion> roll = roll_motion(definition);
  std::vector<MotionPoint> table;
  for (const double t : motion_times(definition, definition.sample_interval / points_per_sample))
    table.push_back({.time = t,
                     .surge = surge.displacement(t),
                     .surge_velocity = surge.velocity(t),
                     .surge_acceleration = surge.acceleration(t),
                     .angle = roll ? roll->angle(t) : 0,
                     .rate = roll ? roll->rate(t) : 0,
                     .angular_acceleration = roll ? roll->acceleration(t) : 0});
  return table;
}

TankGravity tank_gravity(const MotionPoint& motion, double gravity) {
  const double sine = std::sin(motion.angle), cosine = std::cos(motion.angle);
  return {-motion.surge_acceleration * cosine - gravity * sine,
          motion.surge_acceleration * sine - gravity * cosine};
}

double initial_velocity_x(const CaseDefinition& definition) {
  return definition.start == Start::earth ? -surge_motion(definition).velocity(0) : 0;
}

bool starts_against_roll(const CaseDefinition& definition) {
  const std::optional<RollMotion> roll = roll_motion(definition);
  return definition.start == Start::earth && roll && roll->rate(0) != 0;
}

}  // namespace slosh

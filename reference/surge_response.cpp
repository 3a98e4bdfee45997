#include "reference/surge_response.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include "reference/require.hpp"

namespace slosh::reference {
namespace {

const SineSurge& checked(std::string_view where, const SineSurge& motion) {
  require(std::isfinite(motion.amplitude), where, "surge amplitude", motion.amplitude,
          "a finite length, m");
  require(motion.angular_frequency > 0 && std::isfinite(motion.angular_frequency), where,
          "angular frequency", motion.angular_frequency, "a frequency > 0 rad/s");
  require(std::isfinite(motion.phase), where, "phase", motion.phase, "a finite angle, rad");
  return motion;
}

}  // namespace

double SurgeResponse::initial_velocity(const SineSurge& motion) {
  return motion.amplitude * motion.angular_frequency * std::cos(motion.phase);
}

double SurgeResponse::initial_velocity(const AnySurge& motion) { return motion.initial_velocity; }

SurgeResponse::SurgeResponse(std::string_view where, std::vector<TankMode> modes,
                             const SineSurge& motion)
    : where_(where), modes_(std::move(modes)), motion_(checked(where, motion)) {}

SurgeResponse::SurgeResponse(std::string_view where, std::vector<TankMode> modes,
                             const AnySurge& motion)
    : where_(where),
      modes_(std::move(modes)),
      motion_(DuhamelModes(
          modes_, {where, motion.acceleration, motion.duration, motion.step, motion.knots})) {}

double SurgeResponse::checked_time(double t) const {
  const auto* duhamel = std::get_if<DuhamelModes>(&motion_);
  const double last = duhamel ? duhamel->duration() : std::numeric_limits<double>::max();
  return time_within(where_, t, last);
}

double SurgeResponse::tank_acceleration(double t) const {
  if (const auto* duhamel = std::get_if<DuhamelModes>(&motion_)) return duhamel->acceleration(t);
  const auto& [amplitude, omega, phase] = std::get<SineSurge>(motion_);
  return -amplitude * omega * omega * std::sin(omega * t + phase);
}

}  // namespace slosh::reference

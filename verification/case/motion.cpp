#include "verification/case/motion.hpp"

#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

#include "verification/case/cubic_spline.hpp"

namespace slosh {
namespace {

// A factor of time and its first two derivatives.
struct Ramp {
  double value, rate, curvature;
};

Ramp smooth_ramp(double t, double length) {
  if (length == 0 || t >= length) return {1, 0, 0};
  if (t <= 0) return {0, 0, 0};
  const double s = t / length;
  return {s * s * s * (10 - 15 * s + 6 * s * s), 30 * s * s * (1 - s) * (1 - s) / length,
          60 * s * (1 - s) * (1 - 2 * s) / (length * length)};
}

struct History {
  std::function<double(double)> value, rate, acceleration;
};

History history_of(const SineMotion& sine) {
  const double amplitude = sine.amplitude, omega = sine.angular_frequency;
  const double length = sine.ramp_periods * 2 * std::numbers::pi / omega;
  return {
      .value =
          [=](double t) { return amplitude * smooth_ramp(t, length).value * std::sin(omega * t); },
      .rate =
          [=](double t) {
            const Ramp ramp = smooth_ramp(t, length);
            return amplitude *
                   (ramp.rate * std::sin(omega * t) + ramp.value * omega * std::cos(omega * t));
          },
      .acceleration =
          [=](double t) {
            const Ramp ramp = smooth_ramp(t, length);
            return amplitude *
                   ((ramp.curvature - ramp.value * omega * omega) * std::sin(omega * t) +
                    2 * ramp.rate * omega * std::cos(omega * t));
          }};
}

History history_of(const TableMotion& table) {
  const auto spline = std::make_shared<const CubicSpline>(table.time, table.value);
  return {.value = [spline](double t) { return spline->value(t); },
          .rate = [spline](double t) { return spline->first_derivative(t); },
          .acceleration = [spline](double t) { return spline->second_derivative(t); }};
}

History history_of(const MotionHistory& history) {
  return std::visit([](const auto& chosen) { return history_of(chosen); }, history);
}

double frequency_of(const MotionHistory& history) {
  const auto* sine = std::get_if<SineMotion>(&history);
  return sine ? sine->angular_frequency : 0;
}

}  // namespace

SurgeMotion surge_motion(const CaseDefinition& definition) {
  if (!definition.motion.surge) {
    const auto zero = [](double) { return 0.0; };
    return {.displacement = zero, .velocity = zero, .acceleration = zero};
  }
  History history = history_of(*definition.motion.surge);
  return {.displacement = std::move(history.value),
          .velocity = std::move(history.rate),
          .acceleration = std::move(history.acceleration)};
}

std::optional<RollMotion> roll_motion(const CaseDefinition& definition) {
  if (!definition.motion.roll) return std::nullopt;
  const RollDefinition& roll = *definition.motion.roll;
  History history = history_of(roll.angle);
  return RollMotion{.angle = std::move(history.value),
                    .rate = std::move(history.rate),
                    .acceleration = std::move(history.acceleration),
                    .axis_x = roll.axis_x,
                    .axis_z = roll.axis_z};
}

double forcing_frequency(const CaseDefinition& definition) {
  if (definition.declared_forcing_frequency) return *definition.declared_forcing_frequency;
  const auto& [surge, roll] = definition.motion;
  if (!surge && !roll) return 0;
  if (!surge) return frequency_of(roll->angle);
  if (!roll) return frequency_of(*surge);
  return frequency_of(*surge) == frequency_of(roll->angle) ? frequency_of(*surge) : 0;
}

}  // namespace slosh

#include "verification/case/motion.hpp"

#include <fmt/format.h>

#include <algorithm>
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
  const double amplitude = sine.amplitude, omega = sine.angular_frequency, phase = sine.phase;
  const double length = sine.ramp_periods * 2 * std::numbers::pi / omega;
  return {.value =
              [=](double t) {
                return amplitude * smooth_ramp(t, length).value * std::sin(omega * t + phase);
              },
          .rate =
              [=](double t) {
                const Ramp ramp = smooth_ramp(t, length);
                return amplitude * (ramp.rate * std::sin(omega * t + phase) +
                                    ramp.value * omega * std::cos(omega * t + phase));
              },
          .acceleration =
              [=](double t) {
                const Ramp ramp = smooth_ramp(t, length);
                return amplitude * ((ramp.curvature - ramp.value * omega * omega) *
                                        std::sin(omega * t + phase) +
                                    2 * ramp.rate * omega * std::cos(omega * t + phase));
              }};
}

History history_of(const SumOfSines& sum) {
  const auto parts = std::make_shared<std::vector<History>>();
  for (const SineMotion& sine : sum.sines) parts->push_back(history_of(sine));
  const auto summed = [parts](std::function<double(double)> History::*part) {
    return [parts, part](double t) {
      double total = 0;
      for (const History& one : *parts) total += (one.*part)(t);
      return total;
    };
  };
  return {.value = summed(&History::value),
          .rate = summed(&History::rate),
          .acceleration = summed(&History::acceleration)};
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

}  // namespace

std::vector<SineMotion> sines_of(const MotionHistory& history) {
  if (const auto* sine = std::get_if<SineMotion>(&history)) return {*sine};
  const auto* sum = std::get_if<SumOfSines>(&history);
  return sum ? sum->sines : std::vector<SineMotion>{};
}

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

std::vector<ForcedMode> forced_modes(const CaseDefinition& definition) {
  std::vector<double> frequencies;
  const auto add = [&](double frequency) {
    if (std::find(frequencies.begin(), frequencies.end(), frequency) == frequencies.end())
      frequencies.push_back(frequency);
  };
  const auto add_of = [&](const MotionHistory& history) {
    if (std::holds_alternative<TableMotion>(history) && definition.declared_forcing_frequency)
      add(*definition.declared_forcing_frequency);
    for (const SineMotion& sine : sines_of(history)) add(sine.angular_frequency);
  };
  if (definition.motion.surge) add_of(*definition.motion.surge);
  if (definition.motion.roll) add_of(definition.motion.roll->angle);

  std::vector<ForcedMode> modes;
  for (const double frequency : frequencies)
    modes.push_back(
        {frequencies.size() == 1 ? "forced" : fmt::format("forced_{}", modes.size() + 1),
         frequency});
  return modes;
}

bool is_forced(const std::string& mode) { return mode.starts_with("forced"); }

double forcing_frequency(const CaseDefinition& definition) {
  const std::vector<ForcedMode> modes = forced_modes(definition);
  return modes.size() == 1 ? modes.front().angular_frequency : 0;
}

}  // namespace slosh

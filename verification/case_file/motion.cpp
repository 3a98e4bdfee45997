#include "verification/case_file/motion.hpp"

#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "verification/case_file/cubic_spline.hpp"

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

SurgeMotion motion_of(const SineSurge& sine) {
  const double amplitude = sine.amplitude, omega = sine.angular_frequency;
  const double length = sine.ramp_periods * 2 * std::numbers::pi / omega;
  return {
      .displacement =
          [=](double t) { return amplitude * smooth_ramp(t, length).value * std::sin(omega * t); },
      .velocity =
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

SurgeMotion motion_of(const TableSurge& table) {
  const auto spline = std::make_shared<const CubicSpline>(table.time, table.displacement);
  return {.displacement = [spline](double t) { return spline->value(t); },
          .velocity = [spline](double t) { return spline->first_derivative(t); },
          .acceleration = [spline](double t) { return spline->second_derivative(t); }};
}

SurgeMotion motion_of(const Still&) {
  const auto zero = [](double) { return 0.0; };
  return {.displacement = zero, .velocity = zero, .acceleration = zero};
}

SurgeMotion motion_of(const SineRoll& roll) {
  throw CaseFileError(fmt::format(
      "{}:{}: motion.type = \"sine_roll\": expected \"still\", \"sine_surge\" or \"table_surge\"; "
      "no solver takes a roll yet",
      roll.where.file, roll.where.line));
}

double frequency_of(const TableSurge&) { return 0; }
double frequency_of(const Still&) { return 0; }
double frequency_of(const auto& sine) { return sine.angular_frequency; }

}  // namespace

SurgeMotion surge_motion(const CaseDefinition& definition) {
  return std::visit([](const auto& motion) { return motion_of(motion); }, definition.motion);
}

double forcing_frequency(const CaseDefinition& definition) {
  return std::visit([](const auto& motion) { return frequency_of(motion); }, definition.motion);
}

}  // namespace slosh

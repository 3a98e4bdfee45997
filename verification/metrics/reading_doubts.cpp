#include "verification/metrics/reading_doubts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace slosh {
namespace {

constexpr double same_value = 0.015;  // of the range

bool may_rest(double value, const SensorReadings& of) {
  return std::any_of(of.rests.begin(), of.rests.end(), [&](double rest) {
    return std::abs(value - rest) <= same_value * of.limits.range;
  });
}

// An impact leaves its neighbours too: a pressure rises, a load may pull. Impacts do not recur at
// one value, as lost samples do.
bool may_be_real(const IsolatedReadings& isolated, const SensorReadings& of) {
  if (isolated.value) return may_rest(*isolated.value, of);
  return of.unit.starts_with("N") || (of.unit == "Pa" && isolated.above);
}

// Between impacts a pressure and a load rest or fall along other curves than before and after.
bool may_be_real(const LostStretches& lost, const SensorReadings& of) {
  if (lost.value) return may_rest(*lost.value, of);
  return has_impacts(of.unit);
}

// Stretches at the value of a flat are that flat.
bool are_told(const LostStretches& lost, const SensorLimits& limits) {
  const auto is_at = [&](const std::optional<FlatExtreme>& flat) {
    return flat && lost.value && std::abs(flat->value - *lost.value) <= same_value * limits.range;
  };
  return is_at(limits.highest) || is_at(limits.lowest);
}

void add_flat(const SensorReadings& of, const FlatExtreme& flat, const char* which,
              std::vector<std::string>& doubts) {
  doubts.push_back(fmt::format(
      "the {} stays at its {} value, {:.4g} {}, from {:.4g} to {:.4g} s, which cuts off "
      "some {:.2g} {}",
      of.role, which, flat.value, of.unit, flat.begin, flat.end, flat.hidden, of.unit));
}

}  // namespace

bool has_impacts(const std::string& unit) { return unit.starts_with("N") || unit == "Pa"; }

std::vector<std::string> doubts_of_readings(const SensorReadings& of) {
  std::vector<std::string> doubts;
  const auto& [range, step, highest, lowest, sparse, isolated, lost, roughness, growth] = of.limits;
  // A pressure rests at its lowest value alone.
  if (highest && (of.unit == "Pa" || !may_rest(highest->value, of)))
    add_flat(of, *highest, "highest", doubts);
  if (lowest && !may_rest(lowest->value, of)) add_flat(of, *lowest, "lowest", doubts);
  if (sparse)
    doubts.push_back(
        sparse->held
            ? fmt::format(
                  "the {} holds each reading for {:.4g} s: a value is off by some {:.2g} {}",
                  of.role, sparse->interval, sparse->hidden, of.unit)
            : fmt::format("the {} follows straight lines between readings {:.4g} s apart, which "
                          "cut off some {:.2g} {} of a crest",
                          of.role, sparse->interval, sparse->hidden, of.unit));
  if (isolated && !may_be_real(*isolated, of))
    doubts.push_back(fmt::format(
        "{} samples of the {} leave their neighbours alone, as at {:.4g} s: a value is off by some "
        "{:.2g} {} in the mean",
        isolated->count, of.role, isolated->time, isolated->hidden, of.unit));
  if (lost && !may_be_real(*lost, of) && !are_told(*lost, of.limits))
    doubts.push_back(fmt::format(
        "{} stretches of the {}, as from {:.4g} to {:.4g} s, are straight where the curve through "
        "the samples before and after is not, as where an echo is lost: a value is off by some "
        "{:.2g} {} in the mean",
        lost->count, of.role, lost->begin, lost->end, lost->hidden, of.unit));
  if (roughness)
    doubts.push_back(fmt::format(
        "half of the samples of the {} leave their neighbours by {:.2g} of its deviation, as where "
        "two signals alternate",
        of.role, *roughness));
  if (growth && !has_impacts(of.unit))
    doubts.push_back(fmt::format(
        "the samples of the {} leave their neighbours {:.2g} times as far at crests and in troughs "
        "as near the mean, as where many of them are low",
        of.role, *growth));
  return doubts;
}

std::string step_doubt(const SensorReadings& of) {
  const double step = of.limits.step.value();
  return fmt::format(
      "the values of the {} lie {:.3g} {} apart, {:.0f} steps from the lowest to the highest: each "
      "may be off by half a step",
      of.role, step, of.unit, of.limits.range / step);
}

}  // namespace slosh

#include "verification/metrics/reading_doubts.hpp"

#include <fmt/format.h>

#include <cmath>

namespace slosh {
namespace {

constexpr double same_value = 0.015;  // of the range

bool rests_dry(const FlatExtreme& flat, const std::string& unit) {
  return flat.value == 0 && (unit == "Pa" || unit == "N/m" || unit == "N");
}

bool is_shared(const FlatExtreme& flat, const std::optional<FlatExtreme>& other, double range) {
  return other && std::abs(flat.value - other->value) <= same_value * range;
}

void add_flat(const SensorReadings& of, const std::optional<FlatExtreme>& flat, const char* which,
              const std::optional<FlatExtreme>& of_other, std::vector<std::string>& doubts) {
  // A flat of few steps follows from them.
  if (!flat || of.limits.step || rests_dry(*flat, of.unit) ||
      is_shared(*flat, of_other, of.limits.range))
    return;
  doubts.push_back(fmt::format(
      "the {} stays at its {} value, {:.4g} {}, from {:.4g} to {:.4g} s, which cuts off "
      "some {:.2g} {}",
      of.role, which, flat->value, of.unit, flat->begin, flat->end, flat->hidden, of.unit));
}

void add_step(const SensorReadings& of, std::vector<std::string>& doubts) {
  if (const std::optional<double> step = of.limits.step)
    doubts.push_back(fmt::format(
        "the values of the {} lie {:.3g} {} apart, {:.0f} steps from the lowest to the highest: "
        "each may be off by half a step",
        of.role, *step, of.unit, of.limits.range / *step));
}

}  // namespace

std::vector<std::string> reading_doubts(const SensorReadings& of, const SensorReadings& other) {
  std::vector<std::string> doubts;
  add_step(of, doubts);
  add_flat(of, of.limits.highest, "highest", other.limits.highest, doubts);
  add_flat(of, of.limits.lowest, "lowest", other.limits.lowest, doubts);
  return doubts;
}

std::vector<std::string> reading_doubts(const SensorReadings& of) {
  std::vector<std::string> doubts;
  add_step(of, doubts);
  add_flat(of, of.limits.highest, "highest", std::nullopt, doubts);
  return doubts;
}

}  // namespace slosh

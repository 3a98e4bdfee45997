#include <fmt/format.h>
#include <fmt/ranges.h>

#include <numbers>

#include "verification/case_file/case_sections.hpp"

namespace slosh {
namespace {

constexpr double full_turn = 2 * std::numbers::pi;

double angular_frequency_at(const TomlTable& table, const FrequencyKeys& keys) {
  if (table.has(keys.period)) return full_turn / table.get(keys.period, positive("s"));
  if (table.has(keys.frequency)) return full_turn * table.get(keys.frequency, positive("Hz"));
  return table.get(keys.angular_frequency, positive("rad/s"));
}

}  // namespace

FrequencyKeys frequency_keys(const std::string& prefix) {
  return {prefix + "angular_frequency_rad_s", prefix + "frequency_Hz", prefix + "period_s"};
}

std::vector<std::string> FrequencyKeys::all() const {
  return {angular_frequency, frequency, period};
}

std::optional<double> find_angular_frequency(const TomlTable& table, const FrequencyKeys& keys) {
  std::vector<std::string> given;
  for (const std::string& key : keys.all())
    if (table.has(key)) given.push_back(key);
  if (given.empty()) return std::nullopt;
  if (given.size() > 1)
    table.refuse(given.back(), fmt::format("exactly one of {}", fmt::join(keys.all(), " | ")));
  return angular_frequency_at(table, keys);
}

double read_angular_frequency(const TomlTable& table, const FrequencyKeys& keys) {
  const std::optional<double> given = find_angular_frequency(table, keys);
  return given ? *given : angular_frequency_at(table, keys);
}

}  // namespace slosh

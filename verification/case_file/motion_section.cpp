#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <numbers>
#include <utility>

#include "verification/case_file/case_sections.hpp"
#include "verification/case_file/key_table.hpp"
#include "verification/input/time_table.hpp"

namespace slosh {
namespace {

// [deg]. A larger angle is more than one turn, and probably given in another unit.
constexpr double largest_angle = 360;

constexpr int first_line = 2;  // of the data

// [deg]. The tank starts level. The tolerance is far above rounding errors and far below any roll.
constexpr double level_angle = 1e-3;

constexpr double full_turn = 2 * std::numbers::pi;

double angular_frequency_at(const TomlTable& table, const FrequencyKeys& keys) {
  if (table.has(keys.period)) return full_turn / table.get(keys.period, positive("s"));
  if (table.has(keys.frequency)) return full_turn * table.get(keys.frequency, positive("Hz"));
  return table.get(keys.angular_frequency, positive("rad/s"));
}

TimeTable read_whole_motion(const std::filesystem::path& file, const std::string& column,
                            double duration) {
  TimeTable table = read_time_table(file, {column});
  const int last_line = first_line - 1 + static_cast<int>(table.time.size());
  if (table.time.front() != 0) {
    throw table_error(file, first_line, "time_s", fmt::format("{}", table.time.front()),
                      "0 in the first row, in s");
  }
  if (table.time.back() < duration) {
    throw table_error(
        file, last_line, "time_s", fmt::format("{}", table.time.back()),
        fmt::format("a last time of at least the case's duration ({}), in s", duration));
  }
  return table;
}

// [tank lengths]. With an axis further away, a roll becomes a surge and rounding errors become
// noise.
constexpr double farthest_axis = 1000;

// Where the motion's table lies, and how long it must last.
struct TableScope {
  std::filesystem::path case_file;
  double duration;  // [s]
};

// The differences between the tables of a surge and a roll.
struct HistoryForm {
  std::string amplitude_key;
  Rule<double> amplitude;
  double si_per_unit;
  TableMotion (*read_table)(const std::filesystem::path&, double);
  std::vector<std::string> other_keys;
  std::string table;  // of key_table.hpp
};

std::filesystem::path file_beside(const TomlTable& table, const std::filesystem::path& case_file) {
  std::filesystem::path file = case_file.parent_path() / table.get("file", any_text());
  if (!std::filesystem::is_regular_file(file)) {
    table.refuse("file",
                 "a CSV file's path relative to the case file; there is no " + file.string());
  }
  return file;
}

MotionHistory read_history(const TomlTable& table, const HistoryForm& form,
                           const TableScope& scope) {
  const auto allow = [&](std::vector<std::string> keys) {
    keys.insert(keys.end(), form.other_keys.begin(), form.other_keys.end());
    table.allow_only(keys);
  };
  table.allow_only(keys_of(form.table));
  if (table.choice("type", "a motion", {"sine", "table"}) == "table") {
    allow({"type", "file"});
    return form.read_table(file_beside(table, scope.case_file), scope.duration);
  }
  std::vector<std::string> keys{"type", form.amplitude_key, "ramp_periods"};
  const FrequencyKeys frequency = frequency_keys();
  for (const std::string& key : frequency.all()) keys.push_back(key);
  allow(keys);
  return SineMotion{
      .amplitude = table.get(form.amplitude_key, form.amplitude) * form.si_per_unit,
      .angular_frequency = read_angular_frequency(table, frequency),
      .ramp_periods = table.find("ramp_periods", not_negative("periods")).value_or(0)};
}

MotionHistory read_surge(const TomlTable& surge, const TableScope& scope) {
  return read_history(surge, {"amplitude_m", positive("m"), 1, read_surge_table, {}, "surge"},
                      scope);
}

Rule<double> near_the_tank(double tank_length, const char* unit) {
  const double farthest = farthest_axis * tank_length;
  return {fmt::format("a number from -{0} to {0} ({1} tank lengths), in {2}", farthest,
                      farthest_axis, unit),
          [farthest](double place) { return place >= -farthest && place <= farthest; }, 0};
}

RollDefinition read_roll(const TomlTable& roll, const TableScope& scope, double tank_length) {
  const Rule<double> amplitude{
      fmt::format("a number > 0 and <= {}, in deg", largest_angle),
      [](double degrees) { return degrees > 0 && degrees <= largest_angle; }, largest_angle};
  const HistoryForm form{"amplitude_deg",          amplitude, radians_per_degree, read_roll_table,
                         {"axis_x_m", "axis_z_m"}, "roll"};
  return {.angle = read_history(roll, form, scope),
          .axis_x = roll.get("axis_x_m", near_the_tank(tank_length, "m from the left wall")),
          .axis_z = roll.get("axis_z_m", near_the_tank(tank_length, "m from the bottom"))};
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

TableMotion read_surge_table(const std::filesystem::path& file, double duration) {
  TimeTable table = read_whole_motion(file, "displacement_m", duration);
  return {.file = file, .time = std::move(table.time), .value = std::move(table.value)};
}

TableMotion read_roll_table(const std::filesystem::path& file, double duration) {
  TimeTable table = read_whole_motion(file, "angle_deg", duration);
  const auto refuse = [&](std::size_t row, const std::string& expected) {
    throw table_error(file, first_line + static_cast<int>(row), "angle_deg",
                      fmt::format("{}", table.value[row]), expected);
  };
  if (std::abs(table.value.front()) > level_angle)
    refuse(0, fmt::format("0 to within {} in the first row, in deg: the tank starts level",
                          level_angle));
  for (std::size_t row = 0; row < table.value.size(); ++row) {
    if (std::abs(table.value[row]) > largest_angle)
      refuse(row, fmt::format("a number from -{0} to {0}, in deg", largest_angle));
    table.value[row] *= radians_per_degree;
  }
  return {.file = file, .time = std::move(table.time), .value = std::move(table.value)};
}

MotionDefinition read_motion(const TomlTable& motion, const CaseDefinition& definition) {
  motion.allow_only(keys_of("motion"));
  const TableScope scope{definition.file, definition.duration};
  MotionDefinition read;
  if (motion.has("surge")) read.surge = read_surge(motion.table("surge"), scope);
  if (motion.has("roll"))
    read.roll = read_roll(motion.table("roll"), scope, definition.tank.length);
  const bool says_still = motion.flag("still");
  if (motion.has("still") && says_still != read.still())
    motion.refuse("still", read.still() ? "true, or [motion.surge] or [motion.roll] instead"
                                        : "no such key beside [motion.surge] or [motion.roll]");
  if (read.still() && !says_still)
    motion.refuse_table("{}", "still = true, [motion.surge], [motion.roll] or both of these");
  return read;
}

}  // namespace slosh

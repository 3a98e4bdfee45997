#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "verification/case_file/case_sections.hpp"
#include "verification/case_file/motion/roll_limits.hpp"
#include "verification/input/tables/time_table.hpp"

namespace slosh {
namespace {

TimeTable read_whole_motion(const std::filesystem::path& file, const std::string& column,
                            double duration) {
  TimeTable table = read_time_table(file, {column});
  if (table.time.front() != 0) {
    throw table_error(file, table.lines.front(), "time_s", fmt::format("{}", table.time.front()),
                      "0 in the first row, in s");
  }
  if (table.time.back() < duration) {
    throw table_error(
        file, table.lines.back(), "time_s", fmt::format("{}", table.time.back()),
        fmt::format("a last time of at least the case's duration ({}), in s", duration));
  }
  return table;
}

}  // namespace

TableMotion read_surge_table(const std::filesystem::path& file, double duration) {
  TimeTable table = read_whole_motion(file, "displacement_m", duration);
  return {.file = file, .time = std::move(table.time), .value = std::move(table.value)};
}

TableMotion read_roll_table(const std::filesystem::path& file, double duration) {
  TimeTable table = read_whole_motion(file, "angle_deg", duration);
  const auto refuse = [&](std::size_t row, const std::string& expected) {
    throw table_error(file, table.lines[row], "angle_deg", fmt::format("{}", table.value[row]),
                      expected);
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

}  // namespace slosh

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "verification/case/cubic_spline.hpp"
#include "verification/case/motion/motion_times.hpp"
#include "verification/case_file/case_sections.hpp"
#include "verification/case_file/motion/roll_limits.hpp"
#include "verification/input/tables/time_table.hpp"

namespace slosh {
namespace {

// Integrates the cubic spline through accelerations twice, from the position 0 and the velocity 0
// at the time 0. Over an interval of the length h between the values a, b with the spline's second
// derivatives m, n,
//   velocity + h (a + b)/2 - h^3 (m + n)/24,
//   position + h velocity + h^2 (2 a + b)/6 - h^4 (8 m + 7 n)/360.
TableMotion integrated(const TableMotion& accelerations) {
  const CubicSpline spline(accelerations.time, accelerations.value);
  TableMotion motion{accelerations.file, {0}, {0}};
  double velocity = 0, position = 0;
  for (const double t : accelerations.time) {
    const double start = motion.time.back(), h = t - start;
    if (!(h > 1e-9 * shortest_table_step)) continue;
    const double a = spline.value(start), b = spline.value(t);
    const double m = spline.second_derivative(start), n = spline.second_derivative(t);
    position += h * velocity + h * h * (2 * a + b) / 6 - h * h * h * h * (8 * m + 7 * n) / 360;
    velocity += h * (a + b) / 2 - h * h * h * (m + n) / 24;
    motion.time.push_back(t);
    motion.value.push_back(position);
  }
  return motion;
}

// Returns the rows with the case's times.
TimeTable read_rows(const TableFile& table, const std::string& position,
                    const std::string& acceleration) {
  TimeTable rows = read_time_table(table.file, {position, acceleration});
  const auto refuse = [&](std::size_t row, const std::string& expected) {
    throw table_error(table.file, rows.lines[row], "time_s", fmt::format("{}", rows.time[row]),
                      expected + ", in s" +
                          (table.time_offset == 0 ? ""
                                                  : fmt::format(", with time_offset_s = {} added",
                                                                table.time_offset)));
  };
  if (!(rows.time.front() + table.time_offset <= 0)) refuse(0, "0 or less in the first row");
  // An offset leaves a table that is as long as the case short by rounding.
  if (!(rows.time.back() + table.time_offset >= table.duration * (1 - 1e-9)))
    refuse(rows.time.size() - 1,
           fmt::format("a last time of at least the case's duration ({})", table.duration));
  if (!(rows.time[rows.time.size() - 3] + table.time_offset > 0))
    refuse(rows.time.size() - 3, "three rows after 0 or more");
  for (double& time : rows.time) time += table.time_offset;
  return rows;
}

TableMotion motion_of(const std::filesystem::path& file, const TimeTable& rows) {
  TableMotion motion{file, rows.time, rows.value};
  if (rows.column.starts_with("acceleration")) motion = integrated(motion);
  return thinned(motion, shortest_table_step);
}

}  // namespace

TableMotion read_surge_table(const TableFile& table) {
  return motion_of(table.file, read_rows(table, "displacement_m", "acceleration_m_s2"));
}

TableMotion read_roll_table(const TableFile& table) {
  const TimeTable rows = read_rows(table, "angle_deg", "acceleration_deg_s2");
  const auto refuse = [&](std::size_t row, const std::string& expected) {
    throw table_error(table.file, rows.lines[row], rows.column, fmt::format("{}", rows.value[row]),
                      expected);
  };
  TableMotion motion = motion_of(table.file, rows);
  const auto after = std::upper_bound(rows.time.begin(), rows.time.end(), 0.0);
  if (!(std::abs(motion.value.front()) <= level_angle))
    refuse(static_cast<std::size_t>(after - rows.time.begin()) - 1,
           fmt::format("an angle of 0 to within {} at the start, in deg: the tank starts level",
                       level_angle));
  const std::vector<double>& angles = rows.column == "angle_deg" ? rows.value : motion.value;
  for (std::size_t row = 0; row < angles.size(); ++row)
    if (!(std::abs(angles[row]) <= largest_angle))
      refuse(std::min(row, rows.value.size() - 1),
             fmt::format("angles from -{0} to {0}, in deg", largest_angle));
  for (double& angle : motion.value) angle *= radians_per_degree;
  return motion;
}

}  // namespace slosh

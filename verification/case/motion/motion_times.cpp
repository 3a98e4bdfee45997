#include "verification/case/motion/motion_times.hpp"

#include <algorithm>
#include <cmath>

#include "verification/case/cubic_spline.hpp"

namespace slosh {
namespace {

constexpr double rounding = 1e-9;        // of a step, or of the duration
constexpr std::size_t least_points = 4;  // of a spline

TableMotion read_at(const TableMotion& table, double step) {
  const CubicSpline spline(table.time, table.value);
  TableMotion read{table.file, {}, {}};
  const auto steps = static_cast<std::size_t>(table.time.back() / step + rounding);
  for (std::size_t i = 0; i <= std::max(steps, least_points); ++i) {
    read.time.push_back(static_cast<double>(i) * step);
    read.value.push_back(spline.value(read.time.back()));
  }
  return read;
}

void read_at(MotionHistory& history, double step) {
  if (auto* table = std::get_if<TableMotion>(&history)) *table = read_at(*table, step);
}

}  // namespace

TableMotion thinned(const TableMotion& table, double step) {
  TableMotion kept{table.file, {0}, {CubicSpline(table.time, table.value).value(0)}};
  for (std::size_t i = 0; i < table.time.size(); ++i) {
    const double t = table.time[i];
    const bool is_last = i + 1 == table.time.size();
    const bool too_near = t < kept.time.back() + step * (1 - rounding);
    if (t == 0) kept.value.front() = table.value[i];
    if (t <= 0 || (too_near && !is_last)) continue;
    if (too_near && kept.time.size() > 1) {
      kept.time.pop_back();
      kept.value.pop_back();
    }
    kept.time.push_back(t);
    kept.value.push_back(table.value[i]);
  }
  return kept.time.size() < least_points ? table : kept;
}

std::vector<double> motion_knots(const MotionHistory& history, double duration) {
  const auto* table = std::get_if<TableMotion>(&history);
  if (!table) return {};
  std::vector<double> knots{0};
  for (const double t : table->time)
    if (t > rounding * duration && t < (1 - rounding) * duration) knots.push_back(t);
  knots.push_back(duration);
  return knots;
}

std::vector<double> motion_times(const CaseDefinition& definition, double step) {
  const double duration = definition.duration;
  const auto& [surge, roll] = definition.motion;
  std::vector<double> knots{0, duration};
  for (const MotionHistory* history : {surge ? &*surge : nullptr, roll ? &roll->angle : nullptr}) {
    if (!history) continue;
    const std::vector<double> more = motion_knots(*history, duration);
    knots.insert(knots.end(), more.begin(), more.end());
  }
  std::sort(knots.begin(), knots.end());
  const auto are_one = [step](double one, double next) { return next - one < rounding * step; };
  knots.erase(std::unique(knots.begin(), knots.end(), are_one), knots.end());
  std::vector<double> times;
  for (std::size_t k = 0; k + 1 < knots.size(); ++k)
    for (int i = 0; i == 0 || knots[k] + i * step < knots[k + 1] - rounding * step; ++i)
      times.push_back(knots[k] + i * step);
  times.push_back(duration);
  return times;
}

CaseDefinition with_tables_at(CaseDefinition definition, double step) {
  if (definition.motion.surge) read_at(*definition.motion.surge, step);
  if (definition.motion.roll) read_at(definition.motion.roll->angle, step);
  return definition;
}

}  // namespace slosh

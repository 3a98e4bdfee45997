#include "verification/assessment/doubts/motion_noise.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "verification/case/cubic_spline.hpp"
#include "verification/case/motion/motion_times.hpp"

namespace slosh {
namespace {

constexpr double mostly = 0.5, little = 0.1;  // of the acceleration
// Differences over seven points vanish for motions that are quintic there.
constexpr std::size_t stencil = 7;
// The 95 % quantile of the differences of normal noise, in standard deviations. A tank that stops
// or is hit gives few large ones, which leave it alone.
constexpr double covered = 0.95, deviations = 1.95996;

// The divided difference over the points from i on, of unit gain for independent noise.
double difference(const TableMotion& table, std::size_t i) {
  double sum = 0, squares = 0;
  const double scale = table.time[i + stencil - 1] - table.time[i];
  for (std::size_t j = i; j < i + stencil; ++j) {
    double weight = 1;
    for (std::size_t k = i; k < i + stencil; ++k)
      if (k != j) weight *= scale / (table.time[j] - table.time[k]);
    sum += weight * table.value[j];
    squares += weight * weight;
  }
  return std::abs(sum) / std::sqrt(squares);
}

// Returns the standard deviation of the positions about a smooth motion; NaN where one is none.
double scatter(const TableMotion& table) {
  std::vector<double> differences;
  for (std::size_t i = 0; i + stencil <= table.time.size(); ++i) {
    differences.push_back(difference(table, i));
    if (!std::isfinite(differences.back())) return differences.back();
  }
  const auto place =
      static_cast<std::ptrdiff_t>(covered * static_cast<double>(differences.size() - 1));
  std::nth_element(differences.begin(), differences.begin() + place, differences.end());
  return differences[static_cast<std::size_t>(place)] / deviations;
}

double noise_share(const TableMotion& table) {
  const CubicSpline spline(table.time, table.value);
  const double positions = scatter(table);
  double noise = 0, all = 0;
  for (std::size_t i = 1; i < table.time.size(); ++i) {
    const double dt = table.time[i] - table.time[i - 1];
    noise += std::pow(6 * positions / (dt * dt), 2);
    all += std::pow(spline.second_derivative(table.time[i]), 2);
  }
  return noise == 0 ? 0 : std::min(1.0, std::sqrt(noise / all));
}

// Whether the spline through few points still passes near the others.
bool follows(const TableMotion& few, const TableMotion& all) {
  const CubicSpline spline(few.time, few.value);
  double off = 0, squares = 0, sum = 0;
  for (std::size_t i = 0; i < all.time.size(); ++i) {
    off += std::pow(spline.value(all.time[i]) - all.value[i], 2);
    squares += std::pow(all.value[i], 2);
    sum += all.value[i];
  }
  const double spread = squares - sum * sum / static_cast<double>(all.time.size());
  return off <= little * little * spread;
}

// Returns the least time between points that leaves little noise of the same motion, if there is
// one [s].
std::optional<double> wide_enough(const TableMotion& table) {
  constexpr double growth = 1.1;
  for (double step = shortest_table_step;; step *= growth) {
    const TableMotion sparse = thinned(table, step);
    if (sparse.time.size() < stencil) return {};
    if (noise_share(sparse) <= little && follows(sparse, table)) return step;
  }
}

std::string advice(const TableMotion& table) {
  const std::optional<double> step = wide_enough(table);
  if (!step) return "no smoothing of it would leave a tenth: it needs a better gauge";
  return fmt::format(
      "points {:.2g} s apart, or a low-pass at {:.2g} Hz that is written with more digits, would "
      "leave a tenth",
      *step, 1 / (2 * *step));
}

// Only positions are differentiated: the noise of a table of accelerations does not grow.
void add_noise(const char* name, const MotionHistory& history, double unit, const char* unit_name,
               std::vector<ModelLimit>& limits) {
  const auto* table = std::get_if<TableMotion>(&history);
  if (!table || table->of_accelerations || table->time.size() < stencil) return;
  ModelLimit limit{"", noise_share(*table), mostly, "of the acceleration's rms",
                   "6 s / dt^2 of the cubic spline through points that scatter by s"};
  limit.effect =
      fmt::format("the noise of {}, whose table {} scatters by {:.2g} {} at points {:.2g} s apart",
                  name, table->file.filename().string(), scatter(*table) / unit, unit_name,
                  table->time.back() / static_cast<double>(table->time.size() - 1));
  if (limit.exceeded()) limit.effect += "; " + advice(*table);
  limits.push_back(limit);
}

}  // namespace

std::vector<ModelLimit> motion_noise(const CaseDefinition& definition) {
  std::vector<ModelLimit> limits;
  const auto& [surge, roll] = definition.motion;
  if (surge) add_noise("motion.surge", *surge, 1, "m", limits);
  if (roll) add_noise("motion.roll", roll->angle, std::numbers::pi / 180, "deg", limits);
  return limits;
}

std::string doubtful_motion(const CaseDefinition& definition) {
  std::string lines;
  for (const ModelLimit& noise : motion_noise(definition))
    if (noise.exceeded()) lines += "doubtful: " + limit_text(noise) + "\n";
  return lines;
}

}  // namespace slosh

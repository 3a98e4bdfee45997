// Reads a finished case's series and log, and refuses what is not a whole, sound run.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "openfoam_cases/gauge_columns.hpp"
#include "openfoam_cases/read_log.hpp"
#include "openfoam_cases/read_series.hpp"
#include "openfoam_cases/surging_tank.hpp"

namespace slosh::openfoam {
namespace {

namespace fs = std::filesystem;

// The scheme conserves the volume to 1e-12 over 20 s, breaking waves included; 1e-4 of the depth
// would be a visible part of a small wave.
constexpr double volume_tolerance = 1e-4;

// A zone that caught no cell, or a neighbouring column's too, averages something else in silence.
void check_cell_count(const fs::path& file, int expected) {
  std::ifstream in(file);
  for (std::string line; std::getline(in, line) && line.starts_with('#');) {
    if (!line.starts_with("# Cells")) continue;
    const std::string count = line.substr(line.find(':') + 1);
    if (numbers_in(count) == std::vector<double>{static_cast<double>(expected)}) return;
    refuse(file, fmt::format("a column of{} cells, expected {}", count, expected));
  }
  refuse(file, "the number of cells is not given");
}

History column_filling(const SurgingTank& tank, const fs::path& case_directory, int column) {
  const fs::path file = series_file(case_directory, column_name(column), "volFieldValue.dat");
  History filling = read_series(tank, file, 2);
  check_cell_count(file, tank.cells_z);
  return filling;
}

History elevation(const SurgingTank& tank, const fs::path& case_directory, const Gauge& gauge) {
  const GaugeColumns columns = gauge_columns(tank, gauge.x);
  const History left = column_filling(tank, case_directory, columns.left);
  const History right = column_filling(tank, case_directory, columns.left + 1);
  History history{{0}, {0}};  // the still surface that the case was written with
  for (std::size_t i = 0; i < left.time.size(); ++i) {
    const double filling = std::lerp(left.value[i], right.value[i], columns.right_weight);
    history.time.push_back(left.time[i]);
    history.value.push_back(filling * tank.height - tank.fill_depth);
  }
  return history;
}

History liquid_volume(const SurgingTank& tank, const fs::path& case_directory) {
  const fs::path file = series_file(case_directory, "liquid_volume", "volFieldValue.dat");
  History volume = read_series(tank, file, 2);
  const double filled = tank.length * tank.fill_depth;
  for (std::size_t i = 0; i < volume.time.size(); ++i) {
    const double change = volume.value[i] / filled - 1;
    if (!(std::abs(change) <= volume_tolerance)) {
      refuse(file, fmt::format("the liquid's volume has changed by {} of itself at {} s, expected "
                               "at most {}",
                               change, volume.time[i], volume_tolerance));
    }
  }
  volume.time.insert(volume.time.begin(), 0);
  volume.value.insert(volume.value.begin(), filled);
  return volume;
}

// The start sets fluid and tank in relative motion at once: the pressure of the first steps is an
// impulse divided by the time step and says nothing of the flow. Samples of the first three are
// dropped.
History horizontal_force(const SurgingTank& tank, const fs::path& case_directory,
                         const LogReader& log) {
  History force =
      read_series(tank, series_file(case_directory, "wall_force", "force.dat"), 1 + 3 * 3);
  const auto kept = std::upper_bound(force.time.begin(), force.time.end(), log.third_step_time());
  const auto dropped = kept - force.time.begin();
  force.time.erase(force.time.begin(), kept);
  force.value.erase(force.value.begin(), force.value.begin() + dropped);
  return force;
}

}  // namespace

Harvest harvest(const SurgingTank& tank, const fs::path& case_directory) {
  const fs::path log_file = case_directory / "log.interFoam";
  const LogReader log = read_log(log_file);
  if (const std::string failure = log.failure(); !failure.empty()) {
    refuse(log_file, failure + "\n" + log.meaningful_lines());
  }
  Harvest harvest;
  for (const Gauge& gauge : tank.gauges) {
    harvest.elevation[gauge.name] = elevation(tank, case_directory, gauge);
  }
  harvest.horizontal_force = horizontal_force(tank, case_directory, log);
  harvest.liquid_volume = liquid_volume(tank, case_directory);
  const std::vector<double>& volume = harvest.liquid_volume.value;
  harvest.relative_mass_loss = (volume.front() - volume.back()) / volume.front();
  harvest.steps = log.steps();
  harvest.max_courant_number = log.max_courant_number();
  harvest.mean_pressure_iterations = log.mean_pressure_iterations();
  harvest.version = log.version();
  return harvest;
}

}  // namespace slosh::openfoam

// Reads a finished case's series and log, and refuses what is not a whole, sound run.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "openfoam_cases/geometry/front_position.hpp"
#include "openfoam_cases/geometry/gauge_columns.hpp"
#include "openfoam_cases/geometry/initial_liquid.hpp"
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

// The height of the surface in a column of cells, from the start on.
History column_level(const SurgingTank& tank, const TankMesh& mesh, const fs::path& case_directory,
                     int column) {
  const fs::path file = series_file(case_directory, column_name(column), "volFieldValue.dat");
  const History filling = read_series(tank, file, 2);
  const int cells = mesh.free_cells(column);
  check_cell_count(file, cells);
  History level{{0}, {surface_level(mesh, column, initial_depth(tank, mesh, column))}};
  for (std::size_t i = 0; i < filling.time.size(); ++i) {
    level.time.push_back(filling.time[i]);
    level.value.push_back(
        surface_level(mesh, column, filling.value[i] * cells * mesh.cell_height()));
  }
  return level;
}

History elevation(const SurgingTank& tank, const TankMesh& mesh, const fs::path& case_directory,
                  const Gauge& gauge) {
  const GaugeColumns columns = gauge_columns(mesh, gauge.x);
  History history = column_level(tank, mesh, case_directory, columns.left);
  const History right = column_level(tank, mesh, case_directory, columns.right);
  for (std::size_t i = 0; i < history.time.size(); ++i) {
    history.value[i] =
        std::lerp(history.value[i], right.value[i], columns.right_weight) - tank.fill_depth;
  }
  return history;
}

History front(const SurgingTank& tank, const TankMesh& mesh, const fs::path& case_directory) {
  const Rows rows = read_rows(tank, series_file(case_directory, "bottom_row", "alpha.liquid"),
                              1 + bottom_columns(mesh).size());
  std::vector<double> at_start;
  for (const int column : bottom_columns(mesh)) at_start.push_back(liquid_share(tank, {column, 0}));
  History history{{0}, {front_position(mesh, at_start)}};
  for (std::size_t i = 0; i < rows.time.size(); ++i) {
    history.time.push_back(rows.time[i]);
    history.value.push_back(front_position(mesh, rows.values[i]));
  }
  return history;
}

History liquid_volume(const SurgingTank& tank, const TankMesh& mesh,
                      const fs::path& case_directory) {
  const fs::path file = series_file(case_directory, "liquid_volume", "volFieldValue.dat");
  History volume = read_series(tank, file, 2);
  const double filled = initial_volume(tank, mesh);
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
  const TankMesh mesh(tank);
  Harvest harvest;
  harvest.cells = mesh.free_cells();
  for (const Gauge& gauge : tank.gauges) {
    harvest.elevation[gauge.name] = elevation(tank, mesh, case_directory, gauge);
  }
  harvest.horizontal_force = horizontal_force(tank, case_directory, log);
  if (tank.column_width) harvest.front_position = front(tank, mesh, case_directory);
  harvest.liquid_volume = liquid_volume(tank, mesh, case_directory);
  const std::vector<double>& volume = harvest.liquid_volume.value;
  harvest.relative_mass_loss = (volume.front() - volume.back()) / volume.front();
  harvest.steps = log.steps();
  harvest.max_courant_number = log.max_courant_number();
  harvest.mean_pressure_iterations = log.mean_pressure_iterations();
  harvest.version = log.version();
  return harvest;
}

}  // namespace slosh::openfoam

#include "openfoam_cases/output/harvest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "openfoam_cases/errors.hpp"
#include "openfoam_cases/geometry/gauge_columns.hpp"
#include "openfoam_cases/geometry/initial_liquid.hpp"
#include "openfoam_cases/geometry/liquid_edge.hpp"
#include "openfoam_cases/output/read_loads.hpp"
#include "openfoam_cases/output/read_log.hpp"

namespace slosh::openfoam {
namespace {

namespace fs = std::filesystem;

// The scheme conserves the volume to 1e-12 over 20 s, also in breaking waves; 1e-4 of the depth
// would be a visible part of a small wave. compressibleInterFoam conserves neither volume nor mass:
// its liquid changed by 6e-05 of itself in 7.8 s of the violent roll of SPHERIC 10 on 90 x 51
// cells.
double volume_tolerance(const SloshingTank& tank) { return is_compressible(tank) ? 1e-3 : 1e-4; }

// Returns the height of the surface in a column of cells, from the start on.
History column_level(const SloshingTank& tank, const TankMesh& mesh, const fs::path& case_directory,
                     int column) {
  const fs::path file = series_file(case_directory, column_name(column), "volFieldValue.dat");
  const History filling = read_series(tank, file, 2);
  check_cell_count(file, mesh.free_cells(column) * mesh.layers().count());
  History level{{0}, {surface_level(mesh, column, initial_depth(tank, mesh, column))}};
  for (std::size_t i = 0; i < filling.time.size(); ++i) {
    level.time.push_back(filling.time[i]);
    level.value.push_back(surface_level(mesh, column, mesh.depth_of(column, filling.value[i])));
  }
  return level;
}

History elevation(const SloshingTank& tank, const TankMesh& mesh, const fs::path& case_directory,
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

// Returns the highest surface in each probed column by the column's index, from the start on.
std::map<int, History> highest_surfaces(const SloshingTank& tank, const TankMesh& mesh,
                                        const fs::path& case_directory) {
  std::map<int, History> surfaces;
  std::size_t cells = 0;
  for (const int column : probed_columns(tank, mesh)) {
    std::vector<double> at_start;
    for (const int row : free_rows(mesh, column)) {
      at_start.push_back(liquid_share(tank, mesh, {column, row}));
    }
    surfaces[column] = {{0}, {highest_surface(mesh, column, at_start)}};
    cells += at_start.size();
  }
  if (surfaces.empty()) return surfaces;
  const Rows rows =
      read_rows(tank, series_file(case_directory, "gauge_cells", "alpha.liquid"), 1 + cells);
  for (std::size_t i = 0; i < rows.time.size(); ++i) {
    auto next = rows.values[i].begin();
    for (auto& [column, history] : surfaces) {
      const auto end = next + mesh.free_cells(column);
      history.time.push_back(rows.time[i]);
      history.value.push_back(highest_surface(mesh, column, {next, end}));
      next = end;
    }
  }
  return surfaces;
}

History above(double level, History heights) {
  for (double& value : heights.value) value -= level;
  return heights;
}

History front(const SloshingTank& tank, const TankMesh& mesh, const fs::path& case_directory) {
  const Rows rows = read_rows(tank, series_file(case_directory, "bottom_row", "alpha.liquid"),
                              1 + bottom_columns(mesh).size());
  std::vector<double> at_start;
  for (const int column : bottom_columns(mesh))
    at_start.push_back(liquid_share(tank, mesh, {column, 0}));
  History history{{0}, {front_position(mesh, at_start)}};
  for (std::size_t i = 0; i < rows.time.size(); ++i) {
    history.time.push_back(rows.time[i]);
    history.value.push_back(front_position(mesh, rows.values[i]));
  }
  return history;
}

History liquid_volume(const SloshingTank& tank, const TankMesh& mesh,
                      const fs::path& case_directory) {
  const fs::path file = series_file(case_directory, "liquid_volume", "volFieldValue.dat");
  History volume = column_of(read_rows(tank, file, 2), 0, 1 / mesh.layers().depth());
  const double filled = initial_volume(tank, mesh);
  for (std::size_t i = 0; i < volume.time.size(); ++i) {
    const double change = volume.value[i] / filled - 1;
    if (!(std::abs(change) <= volume_tolerance(tank))) {
      refuse(file, fmt::format("the liquid's volume has changed by {} of itself at {} s, expected "
                               "at most {}",
                               change, volume.time[i], volume_tolerance(tank)));
    }
  }
  volume.time.insert(volume.time.begin(), 0);
  volume.value.insert(volume.value.begin(), filled);
  return volume;
}

// Sets the momentum in the earth's frame, that of the tank's motion plus that relative to the tank.
void set_momentum(const SloshingTank& tank, const TankMesh& mesh, const fs::path& case_directory,
                  Harvest& harvest) {
  const fs::path file = series_file(case_directory, "liquid_momentum", "volFieldValue.dat");
  const Rows rows = read_rows(tank, file, 1 + 3);
  check_cell_count(file, mesh.cells_in_all_layers());
  const double per_breadth = tank.liquid.density / mesh.layers().depth();
  harvest.momentum_x = column_of(rows, 0, per_breadth);
  harvest.momentum_z = column_of(rows, 2, per_breadth);
  const double mass = tank.liquid.density * initial_volume(tank, mesh);
  for (std::size_t i = 0; i < rows.time.size(); ++i) {
    harvest.momentum_x.value[i] += mass * tank.velocity(rows.time[i]);
  }
}

}  // namespace

Harvest harvest(const SloshingTank& tank, const fs::path& case_directory) {
  const fs::path log_file = case_directory / (std::string("log.") + program_of(tank));
  const LogReader log = read_log(log_file);
  if (const std::string failure = log.failure(); !failure.empty()) {
    refuse(log_file, failure + "\n" + log.meaningful_lines());
  }
  const TankMesh mesh(tank);
  Harvest harvest;
  harvest.cells = mesh.cells_in_all_layers();
  const std::map<int, History> surfaces = highest_surfaces(tank, mesh, case_directory);
  for (const Gauge& gauge : tank.gauges) {
    harvest.elevation[gauge.name] = elevation(tank, mesh, case_directory, gauge);
    harvest.highest_surface[gauge.name] =
        above(tank.fill_depth, surfaces.at(nearest_column(mesh, gauge.x)));
  }
  harvest.wall_pressure = wall_pressures(tank, mesh, case_directory, log);
  ProbeSeries probed = probe_series(tank, mesh, case_directory, log);
  harvest.velocity_x = std::move(probed.velocity_x);
  harvest.velocity_z = std::move(probed.velocity_z);
  harvest.pressure = std::move(probed.pressure);
  WallForces forces = wall_forces(tank, mesh, case_directory, log);
  harvest.wall_force_x = std::move(forces.x);
  harvest.wall_force_z = std::move(forces.z);
  const Rows force = wall_loads(tank, case_directory, "force.dat", log);
  const double per_breadth = 1 / mesh.layers().depth();
  harvest.force_x = column_of(force, 0, per_breadth);
  harvest.force_z = column_of(force, 2, per_breadth);
  if (tank.roll) {  // y points away from the viewer, so that a clockwise moment is positive
    harvest.moment =
        column_of(wall_loads(tank, case_directory, "moment.dat", log), 1, -per_breadth);
  } else {
    set_momentum(tank, mesh, case_directory, harvest);
  }
  for (const double time : tank.snapshot_times) {
    harvest.snapshots.push_back(read_snapshot(tank, mesh, case_directory, time));
  }
  if (tank.column_width) harvest.front_position = front(tank, mesh, case_directory);
  harvest.liquid_volume = liquid_volume(tank, mesh, case_directory);
  const std::vector<double>& volume = harvest.liquid_volume.value;
  harvest.relative_mass_loss = (volume.front() - volume.back()) / volume.front();
  harvest.steps = log.steps();
  harvest.max_courant_number = log.max_courant_number();
  harvest.mean_pressure_iterations = log.mean_pressure_iterations();
  harvest.faces_in_interface = log.faces_in_interface();
  harvest.version = log.version();
  return harvest;
}

}  // namespace slosh::openfoam

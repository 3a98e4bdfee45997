#include "openfoam_cases/output/read_loads.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "openfoam_cases/errors.hpp"
#include "openfoam_cases/geometry/probe_cells.hpp"
#include "openfoam_cases/geometry/wall_faces.hpp"
#include "openfoam_cases/outline/facing.hpp"

namespace slosh::openfoam {
namespace {

namespace fs = std::filesystem;

// Drops the samples of the first three time steps. At the start fluid and tank are set in relative
// motion at once, so that the pressure of the first steps is an impulse divided by the time step
// and not that of the flow.
Rows after_start(Rows rows, const LogReader& log) {
  const auto kept = std::upper_bound(rows.time.begin(), rows.time.end(), log.third_step_time());
  rows.values.erase(rows.values.begin(), rows.values.begin() + (kept - rows.time.begin()));
  rows.time.erase(rows.time.begin(), kept);
  return rows;
}

Rows gas_pressure(const SloshingTank& tank, const TankMesh& mesh, const fs::path& case_directory,
                  const LogReader& log) {
  const fs::path file = series_file(case_directory, "gas_pressure", "volFieldValue.dat");
  Rows gas = after_start(read_rows(tank, file, 2), log);
  check_cell_count(file, mesh.cells_in_all_layers());
  return gas;
}

void require_same_times(const fs::path& file, const Rows& rows, const Rows& gas) {
  if (rows.time != gas.time) refuse(file, "not sampled at the times of the gas's pressure");
}

// The free part of a wall [m] and the direction out of the liquid.
struct WallPart {
  double length, normal_x, normal_z;
};

bool is_side_wall(const std::string& wall) { return wall == "left" || wall == "right"; }

WallPart wall_part(const TankMesh& mesh, const std::string& wall) {
  const bool is_side = is_side_wall(wall);
  const double outward = wall == "left" || wall == "bottom" ? -1 : 1;
  const auto part = [&](double length) {
    return is_side ? WallPart{length, outward, 0} : WallPart{length, 0, outward};
  };
  if (mesh.cut()) return part(area_towards(*mesh.cut(), wall));
  const int last_column = mesh.columns() - 1, last_row = mesh.rows() - 1;
  int faces = 0;
  for (int k = 0; k <= (is_side ? last_row : last_column); ++k) {
    faces += mesh.is_free(is_side ? Cell{wall == "left" ? 0 : last_column, k}
                                  : Cell{k, wall == "bottom" ? 0 : last_row});
  }
  return part(faces * (is_side ? mesh.cell_height() : mesh.cell_width()));
}

// Returns the sum of values of `width` numbers for each cell, of number `component`, times weights.
double weighted(const std::vector<double>& values, std::size_t width, std::size_t component,
                const std::vector<double>& weights, std::size_t first) {
  double sum = 0;
  for (std::size_t k = 0; k < weights.size(); ++k)
    sum += weights[k] * values[width * (first + k) + component];
  return sum;
}

}  // namespace

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

History column_of(const Rows& rows, std::size_t index, double factor) {
  History history{rows.time, {}};
  for (const std::vector<double>& row : rows.values) history.value.push_back(factor * row[index]);
  return history;
}

Rows wall_loads(const SloshingTank& tank, const fs::path& case_directory, const char* name,
                const LogReader& log) {
  const fs::path file = series_file(case_directory, "wall_force", name);
  const int vectors = tank.gap_friction > 0 ? 4 : 3;
  return after_start(read_rows(tank, file, 1 + 3 * vectors), log);
}

std::map<std::string, History> wall_pressures(const SloshingTank& tank, const TankMesh& mesh,
                                              const fs::path& case_directory,
                                              const LogReader& log) {
  std::map<std::string, History> pressures;
  if (tank.pressure_gauges.empty()) return pressures;
  std::vector<std::vector<FaceShare>> shares;
  std::size_t faces = 0;
  for (const PressureGauge& gauge : tank.pressure_gauges) {
    shares.push_back(face_shares(mesh, gauge));
    faces += shares.back().size();
  }
  const Rows gas = gas_pressure(tank, mesh, case_directory, log);
  const fs::path file = series_file(case_directory, "wall_pressure", "p");
  const Rows rows = after_start(read_rows(tank, file, 1 + faces), log);
  require_same_times(file, rows, gas);
  for (std::size_t i = 0; i < rows.time.size(); ++i) {
    auto face = rows.values[i].begin();
    for (std::size_t k = 0; k < shares.size(); ++k) {
      double pressure = -gas.values[i][0];
      for (const FaceShare& share : shares[k]) pressure += share.weight * *face++;
      History& history = pressures[tank.pressure_gauges[k].name];
      history.time.push_back(rows.time[i]);
      history.value.push_back(pressure);
    }
  }
  return pressures;
}

ProbeSeries probe_series(const SloshingTank& tank, const TankMesh& mesh,
                         const fs::path& case_directory, const LogReader& log) {
  ProbeSeries probed;
  if (tank.probes.empty()) return probed;
  std::vector<std::vector<double>> weights;
  std::size_t cells = 0;
  for (const Probe& probe : tank.probes) {
    weights.emplace_back();
    for (const CellShare& share : cell_shares(mesh, probe.x, probe.z)) {
      weights.back().push_back(share.weight);
      ++cells;
    }
  }
  const auto rows_of = [&](const char* field, std::size_t width) {
    return after_start(
        read_rows(tank, series_file(case_directory, "probe_cells", field), 1 + width * cells), log);
  };
  const Rows velocity = rows_of("U", 3), pressure = rows_of("p", 1),
             liquid = rows_of("alpha.liquid", 1),
             gas = gas_pressure(tank, mesh, case_directory, log);
  for (const auto& [field, rows] :
       {std::pair{"U", &velocity}, {"p", &pressure}, {"alpha.liquid", &liquid}})
    require_same_times(series_file(case_directory, "probe_cells", field), *rows, gas);
  for (std::size_t i = 0; i < gas.time.size(); ++i) {
    std::size_t first = 0;
    for (std::size_t k = 0; k < weights.size(); ++k) {
      std::vector<double> of_liquid = weights[k];
      const double share = weighted(liquid.values[i], 1, 0, weights[k], first);
      for (std::size_t j = 0; j < of_liquid.size(); ++j)
        of_liquid[j] *= liquid.values[i][first + j] / share;
      const bool is_wet = share >= 0.5;
      const std::string& name = tank.probes[k].name;
      const auto push = [&](std::map<std::string, History>& histories, double value) {
        histories[name].time.push_back(gas.time[i]);
        histories[name].value.push_back(is_wet ? value : 0);
      };
      push(probed.velocity_x, weighted(velocity.values[i], 3, 0, of_liquid, first));
      push(probed.velocity_z, weighted(velocity.values[i], 3, 2, of_liquid, first));
      push(probed.pressure,
           weighted(pressure.values[i], 1, 0, weights[k], first) - gas.values[i][0]);
      first += weights[k].size();
    }
  }
  return probed;
}

WallForces wall_forces(const SloshingTank& tank, const TankMesh& mesh,
                       const fs::path& case_directory, const LogReader& log) {
  WallForces forces;
  if (tank.loaded_walls.empty()) return forces;
  const Rows gas = gas_pressure(tank, mesh, case_directory, log);
  for (const std::string& wall : tank.loaded_walls) {
    const fs::path file = series_file(case_directory, "wall_force_" + wall, "force.dat");
    const Rows force = after_start(read_rows(tank, file, 1 + 3 * 3), log);
    require_same_times(file, force, gas);
    const auto [length, normal_x, normal_z] = wall_part(mesh, wall);
    History &along = forces.x[wall], &up = forces.z[wall];
    along = column_of(force, 0, 1 / mesh.layers().depth());
    up = column_of(force, 2, 1 / mesh.layers().depth());
    for (std::size_t i = 0; i < gas.time.size(); ++i) {
      along.value[i] -= gas.values[i][0] * length * normal_x;
      up.value[i] -= gas.values[i][0] * length * normal_z;
    }
    // An inclined side's other component is that of another wall.
    if (mesh.cut()) (is_side_wall(wall) ? forces.z : forces.x).erase(wall);
  }
  return forces;
}

}  // namespace slosh::openfoam

#include "openfoam_cases/check_tank.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "openfoam_cases/errors.hpp"
#include "openfoam_cases/geometry/block_mesh.hpp"
#include "openfoam_cases/geometry/gauge_columns.hpp"
#include "openfoam_cases/geometry/initial_liquid.hpp"
#include "openfoam_cases/geometry/liquid_edge.hpp"
#include "openfoam_cases/geometry/probe_cells.hpp"
#include "openfoam_cases/geometry/wall_faces.hpp"
#include "openfoam_cases/outline/facing.hpp"
#include "openfoam_cases/outline/outline.hpp"

namespace slosh::openfoam {
namespace {

void require_positive(const char* key, double value, const char* unit) {
  require(value > 0 && std::isfinite(value), key, value,
          fmt::format("a positive number of {}", unit));
}

void check_numbers(const SloshingTank& tank) {
  require_positive("length", tank.length, "m");
  require_positive("height", tank.height, "m");
  require_positive("fill_depth", tank.fill_depth, "m");
  require(tank.fill_depth < tank.height, "fill_depth", tank.fill_depth,
          fmt::format("less than the height of {} m", tank.height));
  require_positive("gravity", tank.gravity, "m/s2");
  for (const Fluid& fluid : {tank.liquid, tank.gas}) {
    require_positive("density", fluid.density, "kg/m3");
    require(fluid.kinematic_viscosity >= 0 && std::isfinite(fluid.kinematic_viscosity),
            "kinematic_viscosity", fluid.kinematic_viscosity, "m2/s, zero or above");
  }
  require(tank.gap_friction >= 0 && std::isfinite(tank.gap_friction), "gap_friction",
          tank.gap_friction, "1/s, zero or above");
  require(tank.gap_friction == 0 || tank.liquid.kinematic_viscosity > 0, "gap_friction",
          tank.gap_friction, "zero for a liquid without viscosity");
  require(std::isfinite(tank.initial_relative_velocity), "initial_relative_velocity",
          tank.initial_relative_velocity, "a finite velocity in m/s");
  require_positive("duration", tank.duration, "s");
  require_positive("sample_interval", tank.sample_interval, "s");
  require(tank.sample_interval <= tank.duration, "sample_interval", tank.sample_interval,
          fmt::format("at most the duration of {} s", tank.duration));
  require(tank.cells_x >= 2, "cells_x", tank.cells_x, "at least 2");
  require(tank.cells_z >= 2, "cells_z", tank.cells_z, "at least 2");
  require(tank.processes >= 1 && tank.processes <= tank.cells_x, "processes", tank.processes,
          "between 1 and cells_x");
  require(!tank.no_slip || tank.liquid.kinematic_viscosity > 0, "kinematic_viscosity",
          tank.liquid.kinematic_viscosity, "above 0 m2/s for a liquid that sticks to the walls");
  if (tank.gap) {
    require(tank.no_slip, "gap breadth", tank.gap->breadth,
            "walls to which the liquid sticks (no_slip) in three dimensions");
    require(tank.gap_friction == 0, "gap_friction", tank.gap_friction,
            "zero in three dimensions, where the mesh has a gap wall");
  }
  // Beyond 1 MULES is no longer bounded.
  const auto require_courant_number = [](const char* name, double number) {
    require(number > 0 && number <= 1, name, number, "above 0 and at most 1");
  };
  require_courant_number("courant_number", tank.courant_number);
  require_courant_number("interface_courant_number", tank.interface_courant_number);
  require(tank.outer_corrections >= 1 && tank.outer_corrections <= 10, "outer_corrections",
          tank.outer_corrections, "between 1 and 10");
}

// Refuses what a mesh that an outline cuts cannot carry.
void check_cut_tank(const SloshingTank& tank) {
  check_outline(tank);
  if (tank.column_width)
    throw std::invalid_argument(fmt::format(
        "OpenFOAM tank: column_width = {}: expected none in a tank with an outline, whose bottom "
        "may not be level for the front to run along",
        *tank.column_width));
}

// DarcyForchheimer finds no viscosity of the mixture in compressibleInterFoam.
void check_compressible_tank(const SloshingTank& tank) {
  require(tank.gap_friction == 0, "gap_friction", tank.gap_friction,
          "zero for compressibleInterFoam, which knows no friction of the gap walls");
}

void check_gauges(const SloshingTank& tank, const TankMesh& mesh) {
  std::set<std::string> names;
  for (const Gauge& gauge : tank.gauges) {
    require(gauge.x >= 0 && gauge.x <= tank.length, "gauge x", gauge.x,
            fmt::format("between the walls, 0 and {} m", tank.length));
    if (!names.insert(gauge.name).second) {
      throw std::invalid_argument("OpenFOAM tank: two gauges are named \"" + gauge.name + "\"");
    }
    const GaugeColumns columns = gauge_columns(mesh, gauge.x);
    require(mesh.free_cells(columns.left) > 0 && mesh.free_cells(columns.right) > 0, "gauge x",
            gauge.x, "a place where the obstacles leave room for the liquid");
  }
}

void check_pressure_gauges(const SloshingTank& tank, const TankMesh& mesh) {
  std::set<std::string> names;
  for (const PressureGauge& gauge : tank.pressure_gauges) {
    face_shares(mesh, gauge);
    if (!names.insert(gauge.name).second) {
      throw std::invalid_argument("OpenFOAM tank: two pressure gauges are named \"" + gauge.name +
                                  "\"");
    }
  }
}

void check_probes(const SloshingTank& tank, const TankMesh& mesh) {
  for (const Probe& probe : tank.probes) cell_shares(mesh, probe.x, probe.z);
}

// Refuses a wall that has no patch.
void check_loaded_walls(const SloshingTank& tank, const TankMesh& mesh) {
  const auto faces_of = block_mesh(mesh).faces_of;
  const auto exists = [&](const std::string& wall) {
    if (mesh.cut()) return !patches_of(*mesh.cut(), wall).empty();
    return wall != "obstacles" && wall != "front" && faces_of.contains(wall);
  };
  for (const std::string& wall : tank.loaded_walls) {
    if (!exists(wall)) {
      throw std::invalid_argument("OpenFOAM tank: loaded wall \"" + wall +
                                  "\": expected left, right, bottom or roof, not covered by "
                                  "obstacles");
    }
  }
}

void check_roll(const Roll& roll) {
  require(std::isfinite(roll.axis_x), "roll axis x", roll.axis_x, "a finite place in m");
  require(std::isfinite(roll.axis_z), "roll axis z", roll.axis_z, "a finite place in m");
  require(std::isfinite(roll.initial_relative_rate), "roll initial_relative_rate",
          roll.initial_relative_rate, "a finite rate in rad/s");
}

void check_snapshots(const SloshingTank& tank) {
  for (const double time : tank.snapshot_times) {
    require(time > 0 && time <= tank.duration, "snapshot time", time,
            fmt::format("above 0 and at most the duration of {} s", tank.duration));
  }
}

// Checks that the wave's trough leaves the bottom wet and its crest the roof dry.
void check_wave(const InitialWave& wave, const SloshingTank& tank) {
  require(wave.mode >= 1, "initial_wave mode", wave.mode, "1, 2, ...");
  const double most = std::min(tank.fill_depth, tank.height - tank.fill_depth);
  require(std::abs(wave.amplitude) < most, "initial_wave amplitude", wave.amplitude,
          fmt::format("a magnitude below {} m", most));
  require(!tank.column_width && tank.obstacles.empty(), "initial_wave mode", wave.mode,
          "no wave on a column of liquid or over obstacles");
}

void check_disturbance(const InitialWave& wave, const SloshingTank& tank) {
  require(!tank.initial_wave, "start_disturbance amplitude", wave.amplitude,
          "none beside an initial wave");
  check_wave(wave, tank);
}

void check_liquid(const SloshingTank& tank, const TankMesh& mesh) {
  if (tank.column_width) {
    require(*tank.column_width > 0 && *tank.column_width < tank.length, "column_width",
            *tank.column_width, fmt::format("between the walls, 0 and {} m", tank.length));
    require(!bottom_columns(mesh).empty(), "column_width", *tank.column_width,
            "a bottom that the obstacles do not cover, for the front to run along");
  }
  const double volume = initial_volume(tank, mesh);
  const double room = mesh.room();
  // 1e-9 of the room is what round-off alone could give.
  require(volume > 1e-9 * room && volume < (1 - 1e-9) * room, "liquid volume per metre", volume,
          fmt::format("between nothing and the {} m2 that the {} leave{}", room,
                      mesh.cut() ? "outline" : "obstacles", mesh.cut() ? "s" : ""));
}

}  // namespace

void check_tank(const SloshingTank& tank) {
  check_numbers(tank);
  if (!tank.outline.empty()) check_cut_tank(tank);
  if (is_compressible(tank)) check_compressible_tank(tank);
  const TankMesh mesh(tank);
  if (tank.roll) check_roll(*tank.roll);
  if (tank.initial_wave) check_wave(*tank.initial_wave, tank);
  if (tank.start_disturbance) check_disturbance(*tank.start_disturbance, tank);
  check_snapshots(tank);
  check_gauges(tank, mesh);
  check_pressure_gauges(tank, mesh);
  check_probes(tank, mesh);
  if (!tank.loaded_walls.empty()) check_loaded_walls(tank, mesh);
  check_liquid(tank, mesh);
}

}  // namespace slosh::openfoam

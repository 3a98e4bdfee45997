// Reads the series, fields and log of a finished case and checks that the run is complete and
// sound.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "openfoam_cases/output/read_series.hpp"
#include "openfoam_cases/output/read_snapshot.hpp"
#include "openfoam_cases/sloshing_tank.hpp"

namespace slosh::openfoam {

// Forces, moment and momentum are per metre of width, along the tank's axes. In three dimensions so
// is the volume; elevations are means over the gap, and pressures, probes, the highest surface, the
// front and fields are those in the middle of the gap.
struct Harvest {
  // The liquid's surface [m] above the fill depth by gauge name (gauge_columns.hpp).
  std::map<std::string, History> elevation;
  // The highest place [m] above the fill depth where the gauge's column is half full, by gauge name
  // (liquid_edge.hpp).
  std::map<std::string, History> highest_surface;
  // Pressure [Pa] by gauge name, less the gas's mean pressure at the same time (wall_faces.hpp).
  std::map<std::string, History> wall_pressure;
  // At the probes (probe_cells.hpp): the velocity relative to the tank [m/s], and the pressure [Pa]
  // less the gas's mean pressure at the same time; zero while a probe is dry.
  std::map<std::string, History> velocity_x, velocity_z, pressure;
  // Force on each recorded wall [N/m], less that of the gas's mean pressure at the same time.
  std::map<std::string, History> wall_force_x, wall_force_z;
  // x [m] of the front along the bottom (liquid_edge.hpp) of a liquid that started as a column;
  // empty for any other.
  History front_position;
  // Force of the liquid and gas on the tank and its obstacles [N/m].
  History force_x, force_z;
  // Moment of the same about the roll's axis, counter-clockwise positive [N m/m]; empty without
  // roll.
  History moment;
  // Momentum of the liquid in the earth's frame [kg/s]; empty with roll.
  History momentum_x, momentum_z;
  History liquid_volume;                 // per metre of width [m2]
  std::vector<FieldSnapshot> snapshots;  // in the order of the tank's snapshot_times
  double cells = 0;                      // of the mesh, without the obstacles'
  double steps = 0;
  double max_courant_number = 0;
  double mean_pressure_iterations = 0;  // per time step
  double faces_in_interface = 0;        // of interIsoFoam (read_log.hpp)
  double relative_mass_loss = 0;        // (first - last volume) / first
  std::string version;                  // as the log's banner gives it
};

// Throws RunError where the log shows no success; where a series is missing, ends early, has a gap
// or a number that is not finite; where a snapshot is missing or late; and where the liquid's
// volume has drifted. Elevation, surface and volume begin with the state at time 0, momentum with
// the first sample. Pressure, force, moment and all that probes read leave out the first three
// steps, whose pressure is the impulse of the start.
Harvest harvest(const SloshingTank& tank, const std::filesystem::path& case_directory);

}  // namespace slosh::openfoam

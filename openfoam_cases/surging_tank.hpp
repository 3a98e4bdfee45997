// interFoam (VOF) in a surging rectangular tank: the case's input, its directory, its run and its
// harvest. Solved in the tank's frame on a static mesh with a tabulated acceleration, slip walls; x
// from the left wall, z up from the bottom. The liquid stands level or as a dam about to break, and
// the tank may carry obstacles.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace slosh::openfoam {

struct Fluid {
  double density;              // [kg/m3]
  double kinematic_viscosity;  // [m2/s]
};

struct Gauge {
  std::string name;
  double x;  // [m] from the left wall
};

// A rectangle that the tank carries, its walls like the tank's own [m]. May touch the tank's walls
// and other obstacles. Its edges lie on faces of the uniform cells, to a hundredth of a cell.
struct Obstacle {
  double left, right;  // from the left wall
  double bottom, top;  // from the tank's bottom
};

struct SurgingTank {
  double length, height, fill_depth;  // [m]
  // The liquid stands from the left wall to here [m], and from wall to wall where this is empty.
  std::optional<double> column_width = {};
  std::vector<Obstacle> obstacles = {};
  double gravity;  // [m/s2], downward
  Fluid liquid, gas;
  std::function<double(double)> acceleration;  // X''(t) of the tank [m/s2]
  double initial_relative_velocity;  // of liquid and gas against the tank [m/s]: -X'(0) for a start
                                     // at rest in the earth's frame
  double duration;                   // [s]
  double sample_interval;            // [s]
  std::vector<Gauge> gauges;
  int cells_x, cells_z;
  int processes = 1;
};

// A run that gave no usable result. what() names the stage (blockMesh, interFoam, ...), what went
// wrong (missing binary, exit status, signal, incomplete, warning) and the log's last meaningful
// lines.
struct RunError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct History {
  std::vector<double> time, value;
};

struct Harvest {
  // By gauge name: the liquid's surface [m] above the fill depth (gauge_columns.hpp).
  std::map<std::string, History> elevation;
  // Of a liquid that stood as a column: x of the furthest liquid along the bottom [m]
  // (front_position.hpp); empty for any other.
  History front_position;
  History horizontal_force;  // of the liquid and gas on the tank and its obstacles, per metre of
                             // width [N/m]
  History liquid_volume;     // per metre of width [m2]
  double cells = 0;          // of the mesh, the obstacles' left out
  double steps = 0;
  double max_courant_number = 0;
  double mean_pressure_iterations = 0;  // per time step
  double relative_mass_loss = 0;        // (first - last volume) / first
  std::string version;                  // as the log's banner gives it
};

// Called now and then with the simulated time [s] and the number of steps so far.
using Progress = std::function<void(double time, double steps)>;

// Fills every file of the template directory into the same place of the case directory, which must
// be absent or empty. Throws std::invalid_argument for a tank that cannot be or a directory with
// something in it, RunError for a template that names what nothing defines.
void write_case(const SurgingTank& tank, const std::filesystem::path& template_directory,
                const std::filesystem::path& case_directory);

// blockMesh, topoSet, decomposePar (on several processes) and interFoam, each of whose output stays
// in log.<stage> of the case directory. Throws RunError. The programs are in the caller's process
// group, and are ended where `progress` throws.
void run_case(const SurgingTank& tank, const std::filesystem::path& case_directory,
              const Progress& progress);

// Throws RunError where the log shows no success, or a series is missing, ends early, has a hole or
// a number that is not finite, or the liquid's volume has drifted. Elevation and volume begin with
// the state at time 0; the force leaves out the first three steps, whose pressure is the impulse of
// the start.
Harvest harvest(const SurgingTank& tank, const std::filesystem::path& case_directory);

// The installed version ("1912"), or an empty string where interFoam is absent.
std::string installed_version();

}  // namespace slosh::openfoam

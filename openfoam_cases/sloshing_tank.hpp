// interFoam (VOF) in a rectangular tank that surges, rolls or both: the case's input, its
// directory, its run and its harvest. Solved in the tank's frame on a static mesh with a tabulated
// acceleration, slip walls; x from the left wall, z up from the bottom. The liquid stands level,
// under a wave or as a dam about to break, and the tank may carry obstacles.
#pragma once

#include <filesystem>
#include <functional>
#include <limits>
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

// A sensor in a wall of the tank, which measures the mean over its width, centred on its position.
struct PressureGauge {
  enum class Wall { left, right, bottom };
  std::string name;
  Wall wall;
  double position;  // [m] above the bottom, or from the left wall
  double width;     // [m] along the wall; 0: a point
};

// The level at the start, amplitude cos(mode pi x / length) above the fill depth.
struct InitialWave {
  int mode;          // half waves between the walls
  double amplitude;  // [m]
};

// A rotation about an axis that the tank's surge carries along, counter-clockwise positive with x
// to the right and z up; the tank stands upright at the angle 0.
struct Roll {
  std::function<double(double)> angle, rate, acceleration;  // [rad], [rad/s], [rad/s2]
  double axis_x, axis_z;         // [m] from the tank's bottom left corner, outside it too
  double initial_relative_rate;  // of liquid and gas against the tank [rad/s]: -rate(0) for a start
                                 // at rest in the earth's frame
};

struct SloshingTank {
  double length, height, fill_depth;  // [m]
  // The liquid stands from the left wall to here [m], and from wall to wall where this is empty.
  std::optional<double> column_width = {};
  std::vector<Obstacle> obstacles = {};
  std::optional<InitialWave> initial_wave = {};  // with neither a column nor obstacles
  // Of a level that would stand still: what sets repeats of a run apart (start_disturbance.hpp).
  // With neither a column nor obstacles nor a wave.
  std::optional<InitialWave> start_disturbance = {};
  double gravity;  // [m/s2], downward
  Fluid liquid, gas;
  std::function<double(double)> velocity, acceleration;  // X'(t) [m/s], X''(t) [m/s2] of the surge,
                                                         // along the earth's horizontal
  double initial_relative_velocity;  // of liquid and gas against the tank [m/s]: -X'(0) for a start
                                     // at rest in the earth's frame
  std::optional<Roll> roll = {};
  double duration;         // [s]
  double sample_interval;  // [s]
  std::vector<Gauge> gauges;
  std::vector<PressureGauge> pressure_gauges = {};
  std::vector<double> snapshot_times = {};  // [s]
  int cells_x, cells_z;
  int processes = 1;
};

// A run that gave no usable result. what() names the stage (blockMesh, interFoam, ...), what went
// wrong (missing binary, exit status, signal, incomplete, warning), the log and its meaningful
// lines, each of which is told apart too.
struct RunError : std::runtime_error {
  explicit RunError(const std::string& what_went_wrong, const std::filesystem::path& log_file = {},
                    const std::string& lines = "");

  std::string message;        // one line
  std::filesystem::path log;  // of the program; empty where it left none
  std::string words;          // the program's own, line by line
};

struct History {
  std::vector<double> time, value;
};

// One value a cell, in the same order in all of them; the obstacles' cells are left out.
struct FieldSnapshot {
  double time;                     // [s]
  double cell_width, cell_height;  // [m]
  std::vector<double> x, z;        // of the cells' centres from the tank's bottom left corner [m]
  std::vector<double> velocity_x, velocity_z;  // relative to the tank, along its axes [m/s]
  std::vector<double> pressure;                // less the gas's mean pressure [Pa]
  std::vector<double> liquid_share;            // 0 to 1
};

// Forces, moment and momentum are per metre of width, along the tank's axes.
struct Harvest {
  // By gauge name: the liquid's surface [m] above the fill depth (gauge_columns.hpp).
  std::map<std::string, History> elevation;
  // By gauge name: the highest place [m] above the fill depth where the gauge's column is half full
  // (highest_surface.hpp).
  std::map<std::string, History> highest_surface;
  // By gauge name [Pa], less the gas's mean pressure at that moment (wall_faces.hpp).
  std::map<std::string, History> wall_pressure;
  // Of a liquid that stood as a column: x of the furthest liquid along the bottom [m]
  // (front_position.hpp); empty for any other.
  History front_position;
  // Of the liquid and gas on the tank and its obstacles [N/m].
  History force_x, force_z;
  // Of the same about the roll's axis, counter-clockwise positive [N m/m]; empty without roll.
  History moment;
  // Of the liquid in the earth's frame [kg/s]; empty with roll.
  History momentum_x, momentum_z;
  History liquid_volume;                 // per metre of width [m2]
  std::vector<FieldSnapshot> snapshots;  // in the order of the tank's snapshot_times
  double cells = 0;                      // of the mesh, the obstacles' left out
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
void write_case(const SloshingTank& tank, const std::filesystem::path& template_directory,
                const std::filesystem::path& case_directory);

// [s] of wall time for a stage.
struct TimeLimits {
  double utility = 600;  // each but interFoam; the meshes here take seconds
  double solver = std::numeric_limits<double>::infinity();
};

// blockMesh, topoSet, interFoam, and on several processes decomposePar and, where there are
// snapshots, reconstructPar, each of whose output stays in log.<stage> of the case directory.
// Throws RunError, also at a time limit. The programs are in the caller's process group, and are
// ended with all that they started at a limit and where `progress` throws.
void run_case(const SloshingTank& tank, const std::filesystem::path& case_directory,
              const Progress& progress, const TimeLimits& limits = {});

// Throws RunError where the log shows no success, or a series is missing, ends early, has a hole or
// a number that is not finite, a snapshot is missing or late, or the liquid's volume has drifted.
// Elevation, surface and volume begin with the state at time 0, momentum with the first sample;
// pressure, force and moment leave out the first three steps, whose pressure is the impulse of the
// start.
Harvest harvest(const SloshingTank& tank, const std::filesystem::path& case_directory);

// The installed version ("1912"), or an empty string where interFoam is absent.
std::string installed_version();

}  // namespace slosh::openfoam

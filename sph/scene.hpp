// What an SPH run solves: the tank, its motion, the liquid and what is recorded of it. In the tank,
// x is measured from the left wall and z upward from the bottom.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace slosh::sph {

// A place in the tank [m], from its left wall and its bottom.
struct Corner {
  double x, z;
};

struct Gauge {
  std::string name;
  double x;  // [m] from the left wall; the gauge moves with the tank
};

enum class Wall { left, right, bottom, roof };

struct PressureGauge {
  std::string name;
  Wall wall;
  double position;  // [m] above the bottom, or from the left wall on the bottom
  double width;     // [m] of the sensor along the wall, centred at `position`; 0: a point
  // A point of the outline of a tank that is not rectangular, in place of wall and position.
  std::optional<Corner> at = {};
};

// A place in the tank that moves with it.
struct Probe {
  std::string name;
  double x, z;  // [m] from the left wall and above the bottom
};

// A wall on which the force is recorded. In a tank with an outline a wall is what faces its way:
// the left wall has the x components of the forces on all sides whose outward normal points to the
// left.
struct LoadedWall {
  std::string name;
  Wall wall;
};

// The roll angle theta(t) about an axis that moves with the surge, positive counter-clockwise (x to
// the right, z up).
struct Roll {
  std::function<double(double)> angle;         // [rad]
  std::function<double(double)> rate;          // [rad/s]
  std::function<double(double)> acceleration;  // [rad/s2]
  double axis_x, axis_z;                       // [m] from the tank's bottom left corner
};
inline Roll no_roll() {
  const auto zero = [](double) { return 0.0; };
  return {zero, zero, zero, 0, 0};
}

// Whether the liquid is at rest in the frame of the earth, so that the tank is set off impulsively,
// or moves with the tank.
enum class Start { earth, tank };

// The particles at one time: positions in the tank, from its bottom left corner, and velocities
// relative to the earth, in components along the tank's axes.
struct Snapshot {
  double time;
  std::vector<double> x, z, velocity_x, velocity_z, pressure, density;
};

// A rectangle in the tank, from its left wall and its bottom [m].
struct Rectangle {
  double left, right, bottom, top;
};

// The initial surface is amplitude cos(mode pi x / tank_length) above the still level; the liquid
// under it is at rest.
struct InitialWave {
  int mode;          // half waves between the walls
  double amplitude;  // [m]
};

// Numbers of the scheme that the run changes; an empty one keeps the scheme's value.
struct SchemeNumbers {
  std::optional<double> smoothing_length_ratio;  // h / particle spacing
  std::optional<double> sound_speed_ratio;       // c0 / largest expected speed of the liquid
  std::optional<double> courant_number;          // dt c0 / h
  std::optional<double> artificial_viscosity;    // alpha
  std::optional<double> density_diffusion;       // delta
};

// What a coarse run measured (coarse_run.hpp).
struct CoarseRun {
  double particle_spacing;  // [m]
  double expected_speed;    // V_max [m/s]
};

// How the liquid is prepared (start/initial_state.hpp).
enum class InitialState { lattice, settled, projected };

struct SavedState;

struct Scene {
  double tank_length, tank_height, fill_depth;  // [m]
  // The corners of a tank that is not rectangular, counter-clockwise. Length and height are those
  // of the rectangle around it, whose bottom left corner is the origin.
  std::vector<Corner> outline = {};
  double gravity;                  // [m/s2], downward
  double rest_density;             // [kg/m3], the mean of the still liquid
  double kinematic_viscosity = 0;  // of the liquid [m2/s]
  // The distance between the gap walls, which slow the liquid down
  // (terms/gap_friction.hpp) [m]; 0: there are no such walls.
  double breadth = 0;
  std::function<double(double)> displacement;  // X(t) of the tank [m]
  std::function<double(double)> velocity;      // X'(t) [m/s]
  std::function<double(double)> acceleration;  // X''(t) [m/s2]
  std::optional<Roll> roll = {};
  Start start = Start::earth;
  double duration;                  // [s]
  double sample_interval;           // [s]
  double particle_spacing;          // [m]
  double surface_particle_spacing;  // [m], equal to particle_spacing for a uniform lattice
  // For a dam break, the liquid's extent from the left wall [m]; empty where the liquid fills the
  // tank's length.
  std::optional<double> column_width = {};
  std::vector<Rectangle> obstacles = {};         // fixed in the tank
  std::optional<InitialWave> initial_wave = {};  // excludes a dam and obstacles
  std::string variant = {};                      // of the scheme; empty: none
  SchemeNumbers numbers = {};
  // Whether the largest speed V_max, of which the speed of sound is a multiple, is measured
  // (coarse_run.hpp) and not estimated (scheme.hpp).
  bool speed_from_coarse_run = false;
  // What was measured. Where it is empty, `run` measures it, or takes it from `resume`.
  std::optional<CoarseRun> coarse_run = {};
  std::optional<InitialState> initial_state = {};  // empty: the scheme's own
  // Every particle of the initial lattice is moved along x and z by up to this fraction of its
  // spacing, at most 0.25, at random from the seed. This gives the members of an ensemble for flows
  // that are sensitive to small disturbances.
  double start_disorder = 0;
  unsigned start_seed = 0;
  // The angle by which the initial lattice is turned about the middle of the liquid [rad]. Its rows
  // do not fit the walls, so that it needs initial_state = settled.
  double start_rotation = 0;
  std::vector<Gauge> gauges;
  std::vector<PressureGauge> pressure_gauges = {};
  std::vector<Probe> probes = {};
  std::vector<LoadedWall> loaded_walls = {};
  bool record_still_water = false;    // the deviation from rest (recording/still_water.hpp)
  bool record_energy_budget = false;  // the energy balance (recording/energy_budget.hpp)
  double snapshot_interval = 0;       // [s], a multiple of sample_interval; 0: no snapshot
  std::function<void(const Snapshot&)> record_snapshot;  // called every snapshot_interval
  // `save_state` is called with a restart state (restart/saved_state.hpp) every state_interval [s],
  // a multiple of sample_interval; 0: never. A run restarted from `resume` agrees bit for bit with
  // the run that saved it if both save at the same times.
  double state_interval = 0;
  std::function<void(const SavedState&)> save_state = {};
  const SavedState* resume = nullptr;
  std::optional<int> threads = {};  // empty: chosen by threads_for (threads.hpp)
  // Where false, the run ends with the lattice of its start, which shows whether the scene is
  // valid.
  bool takes_steps = true;
  // Called with the state at the last sample when the run fails after its first sample. The run can
  // be restarted from that state. Where this is empty, no such state is kept.
  std::function<void(const SavedState&)> save_last_good_state = {};
};

// Returns the scene's roll, or one that stands still.
inline const Roll& roll_of(const Scene& scene) {
  static const Roll none = no_roll();
  return scene.roll ? *scene.roll : none;
}

}  // namespace slosh::sph

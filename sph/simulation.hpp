// One SPH run of a rectangular tank that surges and rolls: the scene, the closed list of schemes,
// and what a run returns. x from the left wall's rest position, z up from the bottom.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace slosh::sph {

struct Gauge {
  std::string name;
  double x;  // [m] from the left wall, carried by the tank
};

enum class Wall { left, right, bottom };

struct PressureGauge {
  std::string name;
  Wall wall;
  double position;  // [m] above the bottom, or from the left wall on the bottom
  double width;     // [m] of the sensor along the wall, centred there; 0: a point
};

// theta(t), counter-clockwise positive (x to the right, z up), about an axis that the surge
// carries.
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

// At rest in the frame of the earth, the tank being set off, or with the tank.
enum class Start { earth, tank };

// Particles at one moment: places in the tank, from its bottom left corner, and velocities against
// the earth, along the tank's axes.
struct Snapshot {
  double time;
  std::vector<double> x, z, velocity_x, velocity_z, pressure, density;
};

// A rectangle in the tank, from its left wall and its bottom [m].
struct Rectangle {
  double left, right, bottom, top;
};

// The surface at the start, amplitude cos(mode pi x / tank_length) above the still level, x from
// the left wall; the liquid under it is at rest.
struct InitialWave {
  int mode;          // half waves between the walls
  double amplitude;  // [m]
};

// What a run changes of its scheme's own numbers; empty: as the scheme has it.
struct SchemeNumbers {
  std::optional<double> smoothing_length_ratio;  // h / particle spacing
  std::optional<double> sound_speed_ratio;       // c0 / largest expected speed of the liquid
  std::optional<double> courant_number;          // dt c0 / h
  std::optional<double> artificial_viscosity;    // alpha
  std::optional<double> density_diffusion;       // delta
};

// How the liquid is prepared (initial_state.hpp).
enum class InitialState { lattice, settled, projected };

struct SavedState;

struct Scene {
  double tank_length, tank_height, fill_depth;  // [m]
  double gravity;                               // [m/s2], downward
  double rest_density;                          // [kg/m3]
  double kinematic_viscosity = 0;               // of the liquid [m2/s]
  std::function<double(double)> displacement;   // X(t) of the tank [m]
  std::function<double(double)> velocity;       // X'(t) [m/s]
  std::function<double(double)> acceleration;   // X''(t) [m/s2]
  std::optional<Roll> roll = {};
  Start start = Start::earth;
  double duration;                  // [s]
  double sample_interval;           // [s]
  double particle_spacing;          // [m]
  double surface_particle_spacing;  // [m], equal to particle_spacing for a uniform lattice
  // A dam about to break: the liquid stands from the left wall to here [m], and fills the tank's
  // length otherwise.
  std::optional<double> column_width = {};
  std::vector<Rectangle> obstacles = {};         // carried by the tank
  std::optional<InitialWave> initial_wave = {};  // with neither a dam nor obstacles
  std::string variant = {};                      // of the scheme: one thing changed; empty: none
  SchemeNumbers numbers = {};
  std::optional<InitialState> initial_state = {};  // empty: the scheme's own
  // The start's lattice, every particle moved along x and z by up to this share of its spacing, at
  // most 0.25, at random from the seed: for repeats of a flow that small disturbances decide.
  double start_disorder = 0;
  unsigned start_seed = 0;
  std::vector<Gauge> gauges;
  std::vector<PressureGauge> pressure_gauges = {};
  bool record_still_water = false;    // how far the liquid is from rest (still_water.hpp)
  bool record_energy_budget = false;  // where its energy goes (energy_budget.hpp)
  double snapshot_interval = 0;       // [s], a multiple of sample_interval; 0: no snapshot
  std::function<void(const Snapshot&)> record_snapshot;  // called every snapshot_interval
  // What the run can go on from (saved_state.hpp), every state_interval [s], a multiple of
  // sample_interval; 0: none. A run that goes on from `resume` does bit for bit what the one did
  // that saved it, if both save at the same times.
  double state_interval = 0;
  std::function<void(const SavedState&)> save_state = {};
  const SavedState* resume = nullptr;
  std::optional<int> threads = {};  // empty: as threads_for (threads.hpp) has it
  bool takes_steps =
      true;  // otherwise the run ends at its start, which shows whether it can be made
  // Given what the run was at its last sample after the start, where it goes wrong after that: it
  // can be gone on from, with the same numbers. Empty: the run keeps no such memory.
  std::function<void(const SavedState&)> save_last_good_state = {};
};

// The scene's roll, or one that stands still.
inline const Roll& roll_of(const Scene& scene) {
  static const Roll none = no_roll();
  return scene.roll ? *scene.roll : none;
}

struct History {
  std::vector<double> time, value;
};

struct RecordedSeries {
  std::string name, unit;
  History history;
};

// What a run holds in memory for its particles.
struct HeldArray {
  std::string purpose, name;  // such as "state", "x"
  std::size_t bytes;
};

struct RunOutput {
  std::map<std::string, History> elevation;        // by gauge name [m] above the still level
  std::map<std::string, History> highest_surface;  // by gauge name [m] above the still level
  std::map<std::string, History> wall_pressure;    // by pressure gauge [Pa]
  History front_position;                          // of a breaking dam, from the left wall [m]
  // Of the liquid on the tank, along the tank's axes, per metre of width [N/m], and about the
  // roll's axis [N], counter-clockwise; the moment of a tank that rolls.
  History force_x, force_z, moment;
  History momentum_x, momentum_z;           // of the liquid, against the earth [kg/s]
  History kinetic_energy;                   // of the liquid, in the earth's frame [J/m]
  History potential_energy;                 // of the liquid [J/m], relative to the initial state
  std::vector<RecordedSeries> still_water;  // where the scene asks for it
  std::vector<RecordedSeries> energy;       // where the scene asks for it [J/m]
  double steps = 0;
  std::size_t particles = 0;                  // of the liquid
  std::size_t exchanged_at_walls = 0;         // times that a particle beyond a wall was put back
  std::vector<std::string> active_terms;      // the physics compiled into the scheme
  std::vector<HeldArray> held_arrays;         // at the end of the run; none that is empty
  std::map<std::string, double> diagnostics;  // "smallest_time_step_s", "speed_of_sound_m_s", ...

  // visit(name, series) for all that the samples leave; `output` may be const.
  template <class Output, class Visit>
  static void for_each_series(Output& output, const Visit& visit) {
    visit("elevation", output.elevation);
    visit("highest_surface", output.highest_surface);
    visit("wall_pressure", output.wall_pressure);
    visit("front_position", output.front_position);
    visit("force_x", output.force_x);
    visit("force_z", output.force_z);
    visit("moment", output.moment);
    visit("momentum_x", output.momentum_x);
    visit("momentum_z", output.momentum_z);
    visit("kinetic_energy", output.kinetic_energy);
    visit("potential_energy", output.potential_energy);
    visit("still_water", output.still_water);
    visit("energy", output.energy);
  }
};

// The run went wrong: a non-finite state, a density out of range, a particle outside, a step below
// its limit, energy from nowhere, an unstable fixed step. what() names the first bad particle, its
// state, the time and the cause.
struct SimulationError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Called about ten times a second of wall time with the simulated time [s] and the steps so far.
using Progress = std::function<void(double time, double steps)>;

std::vector<std::string> scheme_names();
// Of the scheme `recommended`: each changes one thing.
std::vector<std::string> variant_names();

// The scheme's largest stable step for liquid at rest [s]; a flow that is violent shortens it, and
// so does landing on the samples. Throws as `run` does for a scheme, a variant or its numbers.
double stable_time_step(const std::string& scheme, const Scene& scene);

// Throws std::invalid_argument for an unknown scheme or variant, or a scene that the scheme does
// not take.
RunOutput run(const std::string& scheme, const Scene& scene, const Progress& progress);

}  // namespace slosh::sph

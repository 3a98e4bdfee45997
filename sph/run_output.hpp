// What an SPH run gives back: its time series, its diagnostics, its progress and its error.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace slosh::sph {

struct History {
  std::vector<double> time, value;
};

struct RecordedSeries {
  std::string name, unit;
  History history;
};

// One array that a run holds in memory for its particles.
struct HeldArray {
  std::string purpose, name;  // such as "state", "x"
  std::size_t bytes;
};

struct RunOutput {
  std::map<std::string, History> elevation;        // by gauge name [m] above the still level
  std::map<std::string, History> highest_surface;  // by gauge name [m] above the still level
  std::map<std::string, History> wall_pressure;    // by pressure gauge [Pa]
  // By probe: the velocity relative to the tank, along its axes [m/s], and the pressure [Pa].
  std::map<std::string, History> velocity_x, velocity_z, pressure;
  // By wall: the force of the liquid on it, along the tank's axes, per metre of width [N/m].
  std::map<std::string, History> wall_force_x, wall_force_z;
  History front_position;  // of a breaking dam, from the left wall [m]
  // Force of the liquid on the tank, along the tank's axes, per metre of width [N/m], and its
  // moment about the roll's axis [N], counter-clockwise; the moment only of a tank that rolls.
  History force_x, force_z, moment;
  History momentum_x, momentum_z;           // of the liquid, relative to the earth [kg/s]
  History kinetic_energy;                   // of the liquid, in the earth's frame [J/m]
  History potential_energy;                 // of the liquid [J/m], relative to the initial state
  std::vector<RecordedSeries> still_water;  // where the scene asks for it
  std::vector<RecordedSeries> energy;       // where the scene asks for it [J/m]
  // Whether the liquid is sound (recording/soundness.hpp); the packing's drift [1] at every tenth
  // sample only.
  std::vector<RecordedSeries> soundness;
  History packing_drift;
  double steps = 0;
  std::size_t particles = 0;                  // of the liquid
  std::size_t exchanged_at_walls = 0;         // how often a particle beyond a wall was put back
  std::vector<std::string> active_terms;      // the physics compiled into the scheme
  std::vector<HeldArray> held_arrays;         // at the end of the run; empty ones are left out
  std::map<std::string, double> diagnostics;  // "smallest_time_step_s", "speed_of_sound_m_s", ...

  // Calls visit(name, series) for every sampled quantity; `output` may be const.
  template <class Output, class Visit>
  static void for_each_series(Output& output, const Visit& visit) {
    visit("elevation", output.elevation);
    visit("highest_surface", output.highest_surface);
    visit("wall_pressure", output.wall_pressure);
    visit("velocity_x", output.velocity_x);
    visit("velocity_z", output.velocity_z);
    visit("pressure", output.pressure);
    visit("wall_force_x", output.wall_force_x);
    visit("wall_force_z", output.wall_force_z);
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
    visit("soundness", output.soundness);
    visit("packing_drift", output.packing_drift);
  }
};

// The run failed: a state that is not finite, a density out of range, a particle outside the tank,
// a time step below its limit, an energy gain without a source, or an unstable fixed step. what()
// names the first bad particle, its state, the time and the cause.
struct SimulationError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Called about ten times a second of wall time with the simulated time [s] and the steps so far.
using Progress = std::function<void(double time, double steps)>;

}  // namespace slosh::sph

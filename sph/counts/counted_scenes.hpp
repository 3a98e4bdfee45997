// The scenes whose instructions and memory are counted: the surging tank of Li et al. 2010, changed
// by parts that are joined by "+", such as "antuono+baffle". The parts are
//   a scheme or a variant      the method; `recommended` where none is named
//   two_spacings               a lattice twice as fine near the surface, for li2010
//   still, roll, baffle, plate, dam, narrow_tank
//                              another scene
//   no_gauge, pressure_gauge, probe, wall_forces, energy_budget, still_water, snapshots,
//   saved_states
//                              what is recorded
#pragma once

#include <string>

#include "sph/simulation.hpp"

namespace slosh::sph {

struct CountedScene {
  std::string scheme;
  Scene scene;
};

// Returns a scene of 900 particles, sampled every 0.01 s. Throws std::invalid_argument for an
// unknown part.
CountedScene counted_scene(const std::string& parts, double duration);

}  // namespace slosh::sph

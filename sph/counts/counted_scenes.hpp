// The scenes whose instructions and memory are counted: the surging tank of Li et al. 2010, or
// parts of it joined by "+", such as "shifting+baffle".
//   a scheme or a variant   how it is solved; `recommended` where none is named
//   two_spacings            a lattice twice as fine near the surface
//   still, roll, baffle, dam                                     other scenes
//   no_gauge, pressure_gauge, energy_budget, still_water, snapshots, saved_states     what is
//   recorded
#pragma once

#include <string>

#include "sph/simulation.hpp"

namespace slosh::sph {

struct CountedScene {
  std::string scheme;
  Scene scene;
};

// 900 particles, sampled every 0.01 s. Throws std::invalid_argument for a part that is none.
CountedScene counted_scene(const std::string& parts, double duration);

}  // namespace slosh::sph

// What the terms of a scheme are made from: the scene's constants and the scheme's own numbers, the
// latter as the run may have changed them.
#pragma once

#include <optional>

namespace slosh::sph {

struct Setting {
  double gravity;              // [m/s2]
  double fill_depth;           // [m]
  double rest_density;         // [kg/m3]
  double kinematic_viscosity;  // of the liquid [m2/s]
  double particle_spacing;     // [m]
  double flattest_cell;        // height over width of the lattice's flattest cell, at most 1
  double smoothing_length_ratio;
  double speed_of_sound;        // c0 [m/s]
  double courant_number;        // dt c0 / h; of a fixed step none
  double artificial_viscosity;  // alpha
  double density_diffusion;     // delta

  double smoothing_length() const { return smoothing_length_ratio * particle_spacing; }
};

}  // namespace slosh::sph

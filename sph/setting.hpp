// The constants that the terms of a scheme depend on: those of the scene, and the scheme's own
// numbers with the changes that the run makes.
#pragma once

#include <optional>

namespace slosh::sph {

struct Setting {
  double gravity;     // [m/s2]
  double fill_depth;  // [m]
  // Where there is no pressure [kg/m3]. It is lower than the scene's density by the mean
  // compression of the still liquid, so that the tank holds the right mass.
  double rest_density;
  double kinematic_viscosity;  // of the liquid [m2/s]
  double breadth;              // between the gap walls [m]; 0 without them
  double particle_spacing;     // [m]
  double flattest_cell;        // height over width of the lattice's flattest cell, at most 1
  double smoothing_length_ratio;
  double expected_speed;        // V_max [m/s]
  double speed_of_sound;        // c0 [m/s]
  double courant_number;        // dt c0 / h; unused by a fixed step
  double artificial_viscosity;  // alpha
  double density_diffusion;     // delta

  double smoothing_length() const { return smoothing_length_ratio * particle_spacing; }
};

}  // namespace slosh::sph

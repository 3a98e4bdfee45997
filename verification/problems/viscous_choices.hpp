// `recommended` for a viscous liquid that fills its box: the liquid's own viscosity, Wendland C2 at
// h = 2 dp, with which sheared particles were measured to lose least, and the Courant number of 0.4
// at which the laminar term is stable up to 0.1 h^2 / nu, with and without particle shifting.
#pragma once

#include "sph/schemes.hpp"

namespace slosh {

struct Viscous : sph::Recommended {
  using Kernel = sph::WendlandC2;
  using Viscosity = sph::LaminarViscosity;
  static constexpr sph::SchemeNumbers numbers{.smoothing_length_ratio = 2,
                                              .sound_speed_ratio = 10,
                                              .courant_number = 0.4,
                                              .artificial_viscosity = {},
                                              .density_diffusion = 0.05};
};

struct ShiftedViscous : Viscous {
  using Shifting = sph::ParticleShifting;
};

}  // namespace slosh

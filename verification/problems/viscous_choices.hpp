// `recommended` for a viscous liquid that fills its box, with and without particle shifting: the
// liquid's own viscosity, and Wendland C2 at h = 2 dp, with which sheared particles were measured
// to lose least. (With the quintic at h = 1.5 dp the leapfrog was measured to diverge at dt c0 / h
// = 0.8 with nu dt / h^2 = 0.11, inside the viscous criterion's 0.125; here that is at most 0.064.)
#pragma once

#include "sph/schemes.hpp"

namespace slosh {

struct Viscous : sph::Recommended {
  using Kernel = sph::WendlandC2;
  using Viscosity = sph::LaminarViscosity;
  static constexpr sph::SchemeNumbers numbers{.smoothing_length_ratio = 2,
                                              .sound_speed_ratio = 10,
                                              .courant_number = 0.8,
                                              .artificial_viscosity = {},
                                              .density_diffusion = 0.05};
};

struct ShiftedViscous : Viscous {
  using Shifting = sph::ParticleShifting;
};

}  // namespace slosh

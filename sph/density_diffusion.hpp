// Numerical diffusion in the continuity equation, per pair, to be summed as
//   drho_a/dt += sum_b V_b pair(d_a - d_b) (dW/dr)/r,
// where `diffused` says what d is.
#pragma once

#include "sph/equation_of_state.hpp"

namespace slosh::sph {

struct NoDensityDiffusion {
  static constexpr const char* name = "";
  static constexpr bool active = false;
};

// delta h c0 * 2 (rho_b - rho_a) r_ba . grad W / r^2 (Molteni & Colagrossi 2009) on the dynamic
// density (p - rho_0 g (fill_depth - z)) / c0^2, that above the hydrostatic one at the same height:
// the still liquid is left alone. As Fourtakas et al. 2019, eq. 13, but with the hydrostatic part
// taken at the particles' heights, not linearised per pair.
struct DynamicDensityDiffusion {
  static constexpr const char* name = "diffusion of the dynamic density";
  static constexpr bool active = true;
  double delta;
  Tait state;
  double gravity, fill_depth;

  template <class Number>
  Number diffused(Number density, Number z) const {
    const Number hydrostatic = state.rest_density * gravity * (fill_depth - z);
    return (state.pressure(density) - hydrostatic) / (state.speed_of_sound * state.speed_of_sound);
  }
  template <class Number, class Length>
  Number pair(Number difference, Length h) const {
    return 2.0 * delta * h * state.speed_of_sound * difference;
  }
};

}  // namespace slosh::sph

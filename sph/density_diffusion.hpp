// Numerical diffusion in the continuity equation, per pair, to be summed as
//   drho_a/dt += sum_b V_b pair(rho_d_a - rho_d_b) (dW/dr)/r,
// where the dynamic density rho_d = (p - rho_0 g (fill_depth - z)) / c0^2 is the density above the
// hydrostatic one at the same height: the still liquid is left alone.
#pragma once

namespace slosh::sph {

struct NoDensityDiffusion {
  static constexpr const char* name = "";
  static constexpr bool active = false;
  double pair(double, double) const { return 0.0; }
};

// delta h c0 * 2 (rho_b - rho_a) r_ba . grad W / r^2 (Molteni & Colagrossi 2009) on the dynamic
// density, as Fourtakas et al. 2019, eq. 13, but with the hydrostatic part taken at the particles'
// heights, not linearised per pair.
struct DynamicDensityDiffusion {
  static constexpr const char* name = "diffusion of the dynamic density";
  static constexpr bool active = true;
  double delta, speed_of_sound;

  double pair(double dynamic_density_difference, double h) const {
    return 2.0 * delta * h * speed_of_sound * dynamic_density_difference;
  }
};

}  // namespace slosh::sph

// Numerical diffusion in the continuity equation, per pair, to be summed as
//   drho_a/dt += sum_b V_b pair(d_a - d_b, h) (dW/dr)/r,
// where `diffused` returns d [kg/m3]. All have the strength 2 delta h c0 (Molteni & Colagrossi
// 2009, whose psi_ab . grad W contains r_ab . r_ab / r^2 = 1); they differ in the quantity d that
// they diffuse. After switch_off() a term adds nothing.
#pragma once

#include "sph/setting.hpp"

namespace slosh::sph {

struct NoDensityDiffusion {
  static constexpr const char* name = "";
  static constexpr bool active = false, reads_gradient = false, of_whole_density = false;

  explicit NoDensityDiffusion(const Setting&) {}
};

// Diffusion of the density itself (Molteni & Colagrossi 2009, eq. 12): the hydrostatic gradient
// diffuses too, which lifts the liquid at a free surface.
struct MolteniColagrossiDiffusion {
  static constexpr const char* name = "density diffusion, Molteni-Colagrossi";
  static constexpr bool active = true, reads_gradient = false;
  static constexpr bool of_whole_density = true;  // the hydrostatic part included
  double strength;                                // 2 delta c0 [m/s]

  explicit MolteniColagrossiDiffusion(const Setting& s)
      : strength(2.0 * s.density_diffusion * s.speed_of_sound) {}
  void switch_off() { strength = 0; }

  template <class Number>
  Number diffused(Number, Number density, Number) const {
    return density;
  }
  template <class Number>
  Number pair(Number difference, double h) const {
    return strength * h * difference;
  }
};

// Diffusion of the dynamic density (p - rho_0 g (fill_depth - z)) / c0^2, which is the excess over
// the hydrostatic density at the same height; it does not act on still liquid. The form is that of
// Fourtakas et al. 2019, eq. 13, except that the hydrostatic part is evaluated at the particles'
// heights instead of being linearised per pair.
struct DynamicDensityDiffusion : MolteniColagrossiDiffusion {
  static constexpr const char* name = "density diffusion, of the dynamic density (Fourtakas)";
  static constexpr bool of_whole_density = false;
  double hydrostatic_gradient, fill_depth, inverse_sound2;

  explicit DynamicDensityDiffusion(const Setting& s)
      : MolteniColagrossiDiffusion(s),
        hydrostatic_gradient(s.rest_density * s.gravity),
        fill_depth(s.fill_depth),
        inverse_sound2(1.0 / (s.speed_of_sound * s.speed_of_sound)) {}

  template <class Number>
  Number diffused(Number pressure, Number, Number z) const {
    return (pressure - hydrostatic_gradient * (fill_depth - z)) * inverse_sound2;
  }
};

// Diffusion of the density without its renormalised linear part (Antuono et al. 2010, eqs 2 and 3):
// the pair subtracts (grad rho_a + grad rho_b) . r_ab / 2 (neighbours/density_gradient.hpp).
struct AntuonoDiffusion : MolteniColagrossiDiffusion {
  static constexpr const char* name = "density diffusion, Antuono (renormalised gradients)";
  static constexpr bool reads_gradient = true;
  using MolteniColagrossiDiffusion::MolteniColagrossiDiffusion;
};

}  // namespace slosh::sph

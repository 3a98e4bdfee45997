// The sums for pressure gradient and velocity divergence over the sources b of a particle a:
//   dv_a/dt   = -A_a sum_b weight_b (strength_a + strength_b + viscous_ab) grad_a W_ab
//   drho_a/dt =  C_a sum_b weight_b (v_a - v_b) . grad_a W_ab
// A is the acceleration factor and C the continuity factor. In each formulation the two sums are
// adjoint, so that pressure work and compression energy balance. A source's volume is
// volume(weight, density), and approximately volume_of_weight times its weight. Where viscous_share
// is 0, viscous_ab adds nothing.
#pragma once

#include "sph/neighbours/lanes.hpp"
#include "sph/setting.hpp"

namespace slosh::sph {

// Symmetric pressure (Monaghan 1992; Li et al. 2010, eqs 6-8):
//   dv_a/dt   = -sum_b m_b (p_a/rho_a^2 + p_b/rho_b^2 + Pi_ab) grad_a W_ab
//   drho_a/dt =  sum_b m_b v_ab . grad_a W_ab
struct MassWeighted {
  static constexpr const char* name =
      "momentum with p_a/rho_a^2 + p_b/rho_b^2, continuity with masses";
  double volume_of_weight;  // [m3/kg]
  double viscous_share = 1;

  explicit MassWeighted(const Setting& s) : volume_of_weight(1.0 / s.rest_density) {}

  double weight(double mass, double) const { return mass; }
  double volume(double weight, double density) const { return weight / density; }
  template <class Number>
  Number strength(Number pressure, Number density) const {
    return pressure / (density * density);
  }
  template <class Number, class Other>
  auto viscous_scale(Number density_a, Other density_b) const {
    return 2.0 * viscous_share * reciprocal(density_a + density_b);
  }
  template <class Number>
  double acceleration_factor(Number) const {
    return 1.0;
  }
  template <class Number>
  double continuity_factor(Number) const {
    return 1.0;
  }
};

// Volumes, consistent at a free surface (Colagrossi, Antuono & Le Touze 2009; Antuono et al. 2010,
// eq. 1):
//   dv_a/dt   = -rho_0/rho_a sum_b V_b (p_a/rho_0 + p_b/rho_0 + Pi_ab) grad_a W_ab
//   drho_a/dt =  rho_a sum_b V_b v_ab . grad_a W_ab
struct VolumeWeighted {
  static constexpr const char* name = "momentum with p_a + p_b, continuity with volumes";
  static constexpr double volume_of_weight = 1.0;
  double rest_density, inverse_rest_density;
  double viscous_share = 1;

  explicit VolumeWeighted(const Setting& s)
      : rest_density(s.rest_density), inverse_rest_density(1.0 / s.rest_density) {}

  double weight(double mass, double density) const { return mass / density; }
  double volume(double weight, double) const { return weight; }
  template <class Number>
  Number strength(Number pressure, Number) const {
    return pressure * inverse_rest_density;
  }
  template <class Number, class Other>
  double viscous_scale(Number, Other) const {
    return viscous_share;
  }
  template <class Number>
  Number acceleration_factor(Number density) const {
    return rest_density / density;
  }
  template <class Number>
  Number continuity_factor(Number density) const {
    return density;
  }
};

}  // namespace slosh::sph

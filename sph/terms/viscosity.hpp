// The viscous part of the momentum equation, per pair: Pi_ab times the density scale of the
// formulation. `approach` is v_ab . r_ab [m2/s], `distance2` is |r_ab|^2 [m2], and `h` is the
// pair's smoothing length [m].
#pragma once

#include "sph/neighbours/lanes.hpp"
#include "sph/setting.hpp"

namespace slosh::sph {

struct NoViscosity {
  static constexpr const char* name = "";
  static constexpr bool active = false;

  explicit NoViscosity(const Setting&) {}
};

// The numbers of the artificial viscosities.
struct ArtificialViscosity {
  static constexpr bool active = true;
  double alpha, speed_of_sound;

  explicit ArtificialViscosity(const Setting& s)
      : alpha(s.artificial_viscosity), speed_of_sound(s.speed_of_sound) {}
};

// Monaghan's artificial viscosity for approaching pairs: -alpha c0 mu + beta mu^2 with
// mu = h v_ab . r_ab / (r^2 + 0.01 h^2) (Monaghan 1992, eq. 4.1, including the 0.01) and
// beta = alpha, as in Li et al. 2010.
struct MonaghanViscosity : ArtificialViscosity {
  static constexpr const char* name = "Monaghan artificial viscosity, approaching pairs";
  using ArtificialViscosity::ArtificialViscosity;

  template <class Number, class Length>
  Number pair(Number approach, Number distance2, Length h) const {
    const Number mu = h * negative_part(approach) * reciprocal(distance2 + 0.01 * h * h);
    return alpha * mu * (mu - speed_of_sound);
  }
};

// The linear term for every pair, which is a Newtonian viscosity nu = alpha h c0 / 8 with a bulk
// part (Antuono et al. 2010, eq. 1; Monaghan 2005, section 8.5).
struct LinearViscosity : ArtificialViscosity {
  static constexpr const char* name = "linear artificial viscosity, all pairs";
  using ArtificialViscosity::ArtificialViscosity;

  template <class Number, class Length>
  Number pair(Number approach, Number distance2, Length h) const {
    return -alpha * speed_of_sound * h * (approach * reciprocal(distance2 + 0.01 * h * h));
  }
};

// The linear term plus von Neumann and Richtmyer's quadratic term beta mu^2 for approaching pairs
// (Monaghan 1992, eq. 4.1, beta = 1). The quadratic term is negligible where the flow is smooth,
// and keeps an impact's energy from remaining as sound.
struct ImpactViscosity : LinearViscosity {
  static constexpr const char* name =
      "artificial viscosity, linear in all pairs, quadratic in approaching ones";
  using LinearViscosity::LinearViscosity;

  template <class Number, class Length>
  Number pair(Number approach, Number distance2, Length h) const {
    // The factor h is in the denominator, which saves one multiplication per pair.
    const Number mu = approach / (distance2 * (1.0 / h) + 0.01 * h), closing = negative_part(mu);
    return closing * closing - alpha * speed_of_sound * mu;
  }
};

// The liquid's own viscosity in the form of Monaghan, Cleary and Gingold: -8 nu v_ab . r_ab / r^2
// in two dimensions (Monaghan 2005, section 8.5, eq. 8.5). On a square lattice the viscosity of the
// sum over pairs differs from nu and depends on the direction of strain, at every spacing. With the
// Kaiser-Bessel kernel it is 0.80 nu for a shear along the rows and 1.17 nu at 45 degrees to them
// at h = 1.5 dp, and 0.93 and 1.04 nu at 2 dp; with the quintic it is 0.82 and 1.15, 0.93 and 1.03
// nu.
struct LaminarViscosity {
  static constexpr const char* name = "laminar viscosity, Monaghan-Cleary-Gingold";
  static constexpr bool active = true;
  double kinematic_viscosity;

  explicit LaminarViscosity(const Setting& s) : kinematic_viscosity(s.kinematic_viscosity) {}

  template <class Number, class Length>
  Number pair(Number approach, Number distance2, Length h) const {
    return -8.0 * kinematic_viscosity * (approach * reciprocal(distance2 + 0.01 * h * h));
  }
};

}  // namespace slosh::sph

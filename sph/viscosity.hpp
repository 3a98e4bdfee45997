// Viscous part of the momentum equation, per pair: Pi_ab times the density scale of the
// formulation. `approach` = v_ab . r_ab [m2/s], `distance2` = |r_ab|^2 [m2], `h` the pair's
// smoothing length [m].
#pragma once

#include "sph/lanes.hpp"

namespace slosh::sph {

struct NoViscosity {
  static constexpr const char* name = "";
  static constexpr bool active = false;
};

// Monaghan's artificial viscosity for approaching pairs: -alpha c0 mu + beta mu^2 with
// mu = h v_ab . r_ab / (r^2 + 0.01 h^2) (Monaghan 1992, eq. 4.1; the 0.01 is his).
struct MonaghanViscosity {
  static constexpr const char* name = "Monaghan artificial viscosity, approaching pairs";
  static constexpr bool active = true;
  double alpha, beta, speed_of_sound;

  template <class Number, class Length>
  Number pair(Number approach, Number distance2, Length h) const {
    const Number mu = h * negative_part(approach) / (distance2 + 0.01 * h * h);
    return mu * (beta * mu - alpha * speed_of_sound);
  }
};

// The same linear term for every pair, which makes it a Newtonian viscosity nu = alpha h c0 / 8
// with a bulk part (Antuono et al. 2010, eq. 1; Monaghan 2005, section 8.5).
struct LinearViscosity {
  static constexpr const char* name = "linear artificial viscosity, all pairs";
  static constexpr bool active = true;
  double alpha, speed_of_sound;

  template <class Number, class Length>
  Number pair(Number approach, Number distance2, Length h) const {
    return -alpha * speed_of_sound * h * approach / (distance2 + 0.01 * h * h);
  }
};

}  // namespace slosh::sph

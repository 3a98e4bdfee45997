// The surface that the liquid is let go under, x from the left wall:
//   height(x) = fill_depth + A cos(k x),   k = m pi / tank_length,
// the wave that the scene may ask for, level without one. The liquid under it starts with the
// hydrostatic pressure below the surface where it stands,
//   p = rho_0 g (height(x) - z),
// which is the wave's own for a long one; the wave's depth profile is for the projected start to
// find (initial_state.hpp).
#pragma once

namespace slosh::sph {

struct Scene;

class InitialSurface {
 public:
  // Throws std::invalid_argument for a wave without a mode, one that bares the bottom or touches
  // the roof, and one on a dam or over obstacles.
  explicit InitialSurface(const Scene& scene);

  double height(double x) const;                     // [m] above the bottom
  double mean_height(double from, double to) const;  // [m], exact, from < to
  double pressure(double x, double z) const;         // hydrostatic [Pa]

 private:
  double fill_depth_, amplitude_, wave_number_, weight_;  // m, m, 1/m, rho_0 g [N/m3]
};

}  // namespace slosh::sph

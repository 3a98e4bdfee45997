// The initial surface, with x from the left wall:
//   height(x) = fill_depth + A cos(k x),   k = m pi / tank_length
// A is 0 where the scene has no initial wave. The pressure under the surface is hydrostatic,
//   p = rho_0 g (height(x) - z),
// which is the pressure of a long wave; the projected start (projection.hpp) finds the depth
// profile of a shorter one.
#pragma once

namespace slosh::sph {

struct Scene;

class InitialSurface {
 public:
  // Throws std::invalid_argument for a mode below 1, a wave that bares the bottom or touches the
  // roof, and a wave with a dam or obstacles.
  explicit InitialSurface(const Scene& scene);

  double height(double x) const;                     // [m] above the bottom
  double mean_height(double from, double to) const;  // [m], exact, from < to
  double pressure(double x, double z) const;         // hydrostatic [Pa]

 private:
  double fill_depth_, amplitude_, wave_number_, weight_;  // m, m, 1/m, rho_0 g [N/m3]
};

}  // namespace slosh::sph

// What linear theory leaves out of the waves in a rectangular tank, to third order in their
// steepness. With eta the elevation, psi the potential on the surface in the tank's frame, D =
// d/dx and G0 = k tanh kh on each cosine mode (Craig & Sulem 1993, J. Comput. Phys. 108:73),
//   eta_t = G psi,   G = G0 + G1 + G2,   G1 = -D eta D - G0 eta G0,
//   G2 = (D D eta^2 G0 + G0 eta^2 D D) / 2 + G0 eta G0 eta G0
//   psi_t = -g eta - x X'' - (D psi)^2 / 2 + (G0 psi)^2 / 2
//           + G0 psi (G1 psi + D eta D psi)
// The same modes are integrated without the products, and the difference of the two is returned.
// Near-resonances of the second order, such as the sum of the forcing's and the first natural
// frequency with that of the second mode, are thus in it, and how frequencies fall or rise with the
// amplitude. Valid for k A below about 0.2; it is an estimate of an error, and no reference.
// Against fully nonlinear potential flow the difference is right to 3 % of itself in surges with k
// A = 0.16 (third_order_waves_test.cpp).
#pragma once

#include <functional>
#include <vector>

#include "reference/standing_wave.hpp"
#include "reference/tank.hpp"

namespace slosh::reference {

struct ThirdOrderWaves {
  Tank tank;
  std::function<double(double)> acceleration = {};  // X'' [m/s2]; empty for a tank at rest
  double initial_velocity = 0;  // of the tank in a liquid at rest in the earth's frame [m/s]
  InitialWave initial_wave = {1, 0};
  double kinematic_viscosity = 0;  // [m2/s]: each mode decays at the rate 2 nu k^2
  bool linear_alone = false;       // leaves `beyond` at zero, for a fraction of the time
};

struct ThirdOrderRecord {
  std::vector<std::vector<double>> linear, beyond;  // [place][time], m; beyond: all less linear
};

// Returns the elevation at places `x` [m] from the tank's CENTRE and at rising times from 0 s on.
// `beyond` is not finite where the waves outgrow the expansion. Throws std::invalid_argument for an
// impossible tank or place.
ThirdOrderRecord third_order_waves(const ThirdOrderWaves& waves, const std::vector<double>& x,
                                   const std::vector<double>& times);

}  // namespace slosh::reference

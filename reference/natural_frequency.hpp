// The natural frequencies of a rectangular tank for an inviscid liquid, small waves and no surface
// tension (Lamb, Hydrodynamics, chapter IX). With k = m pi / length, the densities rho_w of the
// liquid and rho_a of the gas, and the gas's height h_a:
//   one layer    omega^2 = g k tanh kh
//   two layers   omega^2 = g k (rho_w - rho_a) / (rho_w coth kh + rho_a coth k h_a)
#pragma once

#include "reference/tank.hpp"

namespace slosh::reference {

// Both return the angular frequency [rad/s] of the m-th mode, m = 1, 2, ...; surge and roll excite
// the odd modes only. They throw std::invalid_argument for an impossible tank, gas or mode.
double natural_frequency(const Tank& tank, int m);
double natural_frequency(const Tank& tank, const Gas& gas, int m);

}  // namespace slosh::reference

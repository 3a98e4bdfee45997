// How long a step the solver's staggered leapfrog bears on a square lattice at rest, by von
// Neumann's analysis of its own pair sums, which knows nothing of the solver's code but the
// kernel's shape. Lengths in h, speeds in c0, times in h / c0. A wave of the wave number k turns
// the sums over the lattice, V = dp^2, F = (dW/dr) / r, into
//   gradient and divergence  G(k) = sum V r F sin(k.r)
//   density diffusion        d(k) = -2 delta sum V F (1 - cos(k.r))
//   viscosity                N(k) = -8 nu sum V F (1 - cos(k.r)) r r^T / (r^2 + 0.01)
// with nu = alpha / 8 of an artificial viscosity, and a step of length C into
//   u <- (1 - C N) u + C G rho,   rho <- (1 - C d) rho - C G.u
// (the density's phase a quarter period off). It is stable where no eigenvalue of that is above 1.
#pragma once

#include "sph/terms/kernels.hpp"

namespace slosh {

struct LatticeScheme {
  double (*gradient_shape)(double q);  // of the kernel, its normalisation included, h = 1
  double ratio;                        // h / dp
  double viscosity = 0;                // nu / (h c0)
  double diffusion = 0;                // delta
};

template <class Kernel>
double gradient_shape_of(double q) {
  return Kernel::normalisation * Kernel::gradient_shape(q);
}

// The largest factor by which a step of length C = dt c0 / h multiplies a wave of the lattice.
double largest_growth(const LatticeScheme& scheme, double courant_number);

// The longest stable step, as a Courant number, to 1e-4.
double stable_courant_number(const LatticeScheme& scheme);

// The largest stable viscosity nu / (h c0) at a Courant number, and the largest stable delta, to
// 1e-4 of themselves; zero where the scheme is unstable without.
double stable_viscosity(LatticeScheme scheme, double courant_number);
double stable_diffusion(LatticeScheme scheme, double courant_number);

}  // namespace slosh

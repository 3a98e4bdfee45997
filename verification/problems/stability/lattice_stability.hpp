// The longest stable step of the solver's staggered leapfrog on a square lattice at rest, by von
// Neumann's analysis of the pair sums. Of the solver's code it uses the kernel's shape alone.
// Lengths are in h, speeds in c0, times in h / c0. For a wave of wave number k the sums over the
// lattice, with V = dp^2 and F = (dW/dr) / r, become
//   gradient and divergence  G(k) = sum V r F sin(k.r)
//   density diffusion        d(k) = -2 delta sum V F (1 - cos(k.r))
//   viscosity                N(k) = -8 nu sum V F (1 - cos(k.r)) r r^T / (r^2 + 0.01)
// with nu = alpha / 8 for an artificial viscosity, and a step of length C becomes
//   u <- (1 - C N) u + C G rho,   rho <- (1 - C d) rho - C G.u
// (with the density's phase shifted by a quarter period). The step is stable where no eigenvalue of
// this map exceeds 1 in magnitude. The pressure at rest is left out: lattice_buckling.hpp tells
// whether the lattice holds under it.
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

// Returns the largest factor by which a step of length C = dt c0 / h multiplies a lattice wave.
double largest_growth(const LatticeScheme& scheme, double courant_number);

// Returns the longest stable step as a Courant number, to 1e-4.
double stable_courant_number(const LatticeScheme& scheme);

// Return the largest stable viscosity nu / (h c0), or the largest stable delta, at a Courant
// number, to a relative 1e-4; 0 where the scheme is unstable without it.
double stable_viscosity(LatticeScheme scheme, double courant_number);
double stable_diffusion(LatticeScheme scheme, double courant_number);

}  // namespace slosh

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
// this map exceeds 1 in magnitude. The pressure at rest is left out here; whether the lattice
// holds under it stands below.
#pragma once

#include <string>
#include <vector>

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

// Whether a lattice of particles at rest holds under a background pressure, by von Neumann's
// analysis. The momentum sum -1/rho sum V (p_a + p_b) grad W of a lattice whose particles are
// displaced by xi exp(i k.r) changes in two ways: the pressures follow the density, and the slopes
// of the kernel change under the pressure p0 that the particles had before. With
//   g(k) = -sum V sin(k.r) grad W,   H(k) = sum V (grad grad W) (1 - cos(k.r))
// the force per mass is -S xi with
//   S(k) = (c0^2 - 2 p0 / rho) g g^T + (2 p0 / rho) H.
// The term of H comes from the change of the slopes, and -2 p0 / rho from the change of the volumes
// V. In an integral over the plane H = g g^T = k k^T for a long wave, and p0 does nothing. In a sum
// over a lattice the two differ. Where H has a negative eigenvalue, a displacement can grow as
// exp(s t), and the lattice buckles. Where H exceeds its integral, the lattice resists a shear as a
// solid does, and natural modes are too fast.
// The pressure of the first term cannot hold a lattice that H does not hold: density diffusion
// takes it out of a slow wave. Here lengths are in dp and times in dp / sqrt(p0 / rho). At the
// bottom of a tank p0 = rho g depth, so that the growth in a period of a natural mode rises as
// depth / dp.

enum class Lattice { square, hexagonal };  // hexagonal: every particle has six nearest neighbours

// rho c0^2 / p0 at the bottom of a tank with c0 = 10 sqrt(gravity depth).
inline constexpr double stiffness_of_tank = 100;

// Returns the growth rate s of the fastest growing wave, in sqrt(p0 / rho) / dp, with the scheme's
// viscosity and diffusion; 0 where none grows.
double buckling_growth(const LatticeScheme& scheme, Lattice lattice,
                       double stiffness = stiffness_of_tank);

// The same in a box of cells x cells particles on a square lattice with free-slip mirror walls,
// which let only some waves be: no row or column moves along its neighbours against its own image.
double buckling_growth_in_box(const LatticeScheme& scheme, int cells,
                              double stiffness = stiffness_of_tank);

// Returns whether no wave grows: whether H has no negative eigenvalue.
bool holds(const LatticeScheme& scheme, Lattice lattice);

struct Window {
  double low, high;  // of h / dp
};

inline constexpr Window searched_ratios{1.2, 2.6};

// Returns the windows of h / dp within `searched_ratios` in which the lattice holds, to 1e-3. A
// window of less than 0.01 may be left out.
std::vector<Window> windows_that_hold(LatticeScheme scheme, Lattice lattice);

// Returns the windows of more than 0.01 that lie in a window of both.
std::vector<Window> common_windows(const std::vector<Window>& a, const std::vector<Window>& b);

struct NamedKernel {
  std::string name;  // in words
  double (*gradient_shape)(double q);
};
const std::vector<NamedKernel>& kernels_of_schemes();

// Return the relative change of the natural frequency of a mode of wave number k in a tank of still
// depth d, both to first order.
//
// The resistance of a square lattice. A particle sum gives a mode of displacement xi = grad phi
//   omega^2 = int p E_ijkl (d_k xi_i) (d_l xi_j) / int rho xi^2,  E_ijkl = sum V W_,ij r_k r_l,
// by Rayleigh's quotient, where p is the hydrostatic pressure. In an integral over the plane E_ijkl
// = delta_ik delta_jl + delta_il delta_jk, and the quotient becomes g k tanh(k d). The gradient of
// p does not enter: it goes with odd powers of r, which cancel on a lattice.
double frequency_shift_of_lattice(const LatticeScheme& scheme, double k_times_depth);

// The compressibility of the liquid: with sound of speed c0 the mode is slower by
// (g d / c0^2) / (4 cosh^2 k d).
double frequency_shift_of_sound(double sound_speed_ratio, double k_times_depth);

}  // namespace slosh

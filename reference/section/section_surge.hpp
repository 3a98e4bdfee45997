// Linear potential flow in a tank of any polygonal section that moves horizontally by X(t). In the
// tank's frame, with the outline's coordinates, the modes phi_n of section_flow.hpp, the surface's
// middle xm and height h, the relative velocity is grad phi, and
//   phi = sum c_n phi_n,  eta = sum e_n phi_n,
//   on the surface  eta_t = phi_z:                      e_n' = kappa_n c_n
//   and             phi_t + g eta + X'' (x - xm) = 0:   c_n' = -g e_n - X'' <x, phi_n>,
// so that e_n'' + omega_n^2 e_n = -kappa_n <x, phi_n> X''. A start at rest in the tank's frame has
// e_n' = 0; one in the earth's has phi = -X' (x - xm) on the surface, e_n' = -kappa_n <x, phi_n>
// X'. The part of e_n that follows X'' at once is a plane surface, normal to gravity less X''. It
// is summed over all modes in closed form (chi is harmonic, and x - xm on the surface):
//   sum e_n phi_n = -X''/g chi - sum e_n''/omega_n^2 phi_n
//   pressure  p = -rho (g (z - h) + X'' (x - xm - chi) - g sum e_n phi_n)
//   force     F = -rho (X'' (area - sum kappa_n <x, phi_n>^2) - g sum kappa_n <x, phi_n> e_n).
// For a rectangle this is linear_surge.hpp, whose limits of validity it shares. In Li's tank with
// 40 modes, over 0 to 12 s, the elevation differs from that of 2000 antisymmetric modes by at most
// 0.0004 mm (of 3 mm) for a start at rest in the tank and 0.25 mm (of 9 mm) for one in the earth's
// frame, which converges slowly (linear_surge.cpp).
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "reference/section/section_modes.hpp"
#include "reference/surge_response.hpp"

namespace slosh::reference {

// Every function throws std::invalid_argument for NaN and for a position or time outside the liquid
// at rest or the motion's duration; the constructors throw it for an impossible motion.
class SectionSurge {
 public:
  SectionSurge(const SectionModes& modes, Start start, const SineSurge& motion);
  SectionSurge(const SectionModes& modes, Start start, const AnySurge& motion);
  ~SectionSurge();
  SectionSurge(SectionSurge&&) noexcept;

  double elevation(double x, double t) const;  // [m]
  std::vector<double> elevation(double x, std::span<const double> times) const;
  struct Velocity {
    double x, z;  // [m/s], relative to the tank
  };
  Velocity velocity(double x, double z, double t) const;
  double pressure(double x, double z, double t) const;  // gauge [Pa], hydrostatic part included
  std::vector<double> pressure(double x, double z, std::span<const double> times) const;
  double horizontal_force(double t) const;  // of the liquid on the tank, per metre of width [N/m]

 private:
  struct Waves;
  std::unique_ptr<const Waves> waves_;
};

}  // namespace slosh::reference

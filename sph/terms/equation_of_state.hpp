// Pressure from density in a weakly compressible liquid, and the energy that its compression
// stores,
//   e(rho) = integral of p / rho^2 from the rest density,
// which needs no heat: the pressure depends on the density alone.
#pragma once

#include <cmath>

#include "sph/setting.hpp"

namespace slosh::sph {

// Tait: p = B ((rho / rho_0)^7 - 1), B = rho_0 c0^2 / 7 (Monaghan 1994; Li et al. 2010, eq. 9).
struct Tait {
  static constexpr const char* name = "Tait equation of state, gamma = 7";
  double rest_density;    // [kg/m3]
  double speed_of_sound;  // c0 [m/s], at the rest density

  Tait(double density, double sound) : rest_density(density), speed_of_sound(sound) {}
  explicit Tait(const Setting& s) : Tait(s.rest_density, s.speed_of_sound) {}

  double stiffness() const { return rest_density * speed_of_sound * speed_of_sound / 7.0; }

  auto pressure(auto density) const {
    const auto s = density / rest_density, s2 = s * s;
    return stiffness() * (s2 * s2 * s2 * s - 1.0);
  }
  // Inverse, for p > -B.
  double density(double pressure) const {
    return rest_density * std::pow(1.0 + pressure / stiffness(), 1.0 / 7.0);
  }
  // [J/kg], with s = rho / rho_0: B / rho_0 ((s^6 - 1) / 6 + 1 / s - 1), whose terms all but cancel
  // near s = 1; the root at s = 1 is double and taken out.
  double energy(double density) const {
    const double s = density / rest_density, compression = s - 1.0;
    const double rest = ((((s + 2.0) * s + 3.0) * s + 4.0) * s + 5.0) * s + 6.0;
    return stiffness() / rest_density * compression * compression * rest / (6.0 * s);
  }
};

// Linear: p = c0^2 (rho - rho_0) (Antuono et al. 2010, eq. 1).
struct LinearState {
  static constexpr const char* name = "linear equation of state";
  double rest_density;    // [kg/m3]
  double speed_of_sound;  // c0 [m/s]

  explicit LinearState(const Setting& s)
      : rest_density(s.rest_density), speed_of_sound(s.speed_of_sound) {}

  auto pressure(auto density) const {
    return speed_of_sound * speed_of_sound * (density - rest_density);
  }
  double density(double pressure) const {
    return rest_density + pressure / (speed_of_sound * speed_of_sound);
  }
  // [J/kg], with s = rho / rho_0: c0^2 (ln s + 1 / s - 1).
  double energy(double density) const {
    const double compression = density / rest_density - 1.0;
    return speed_of_sound * speed_of_sound *
           (std::log1p(compression) - compression / (1.0 + compression));
  }
};

}  // namespace slosh::sph

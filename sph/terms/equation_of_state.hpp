// Pressure from density in a weakly compressible liquid.
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
};

}  // namespace slosh::sph

// Tait's equation of state: p = B ((rho / rho_0)^7 - 1), B = rho_0 c0^2 / 7 (Monaghan 1994; Li et
// al. 2010, eq. 9).
#pragma once

#include <cmath>

namespace slosh::sph {

struct Tait {
  static constexpr const char* name = "Tait equation of state, gamma = 7";
  double rest_density;    // [kg/m3]
  double speed_of_sound;  // c0 [m/s], at the rest density

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

}  // namespace slosh::sph

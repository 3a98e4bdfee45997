// Pressure from density in a weakly compressible liquid, and the energy that its compression
// stores,
//   e(rho) = integral of p / rho^2 from the rest density
// No heat is involved, because the pressure depends on the density alone.
#pragma once

#include <cmath>

#include "sph/setting.hpp"

namespace slosh::sph {

// Returns s to a whole power, by squares.
template <int power, class Number>
Number to_the(Number s) {
  if constexpr (power == 1) return s;
  if constexpr (power == 2) return s * s;
  if constexpr (power == 3) return s * s * s;
  if constexpr (power == 5) {
    const Number s2 = s * s;
    return s2 * s2 * s;
  }
  if constexpr (power == 7) {
    const Number s2 = s * s;
    return s2 * s2 * s2 * s;
  }
}

// p = B ((rho / rho_0)^gamma - 1), B = rho_0 c0^2 / gamma (Batchelor 1967, section 1.8).
template <int gamma>
struct PowerLawState {
  double rest_density;    // [kg/m3]
  double speed_of_sound;  // c0 [m/s], at the rest density

  PowerLawState(double density, double sound) : rest_density(density), speed_of_sound(sound) {}
  explicit PowerLawState(const Setting& s) : PowerLawState(s.rest_density, s.speed_of_sound) {}

  double stiffness() const { return rest_density * speed_of_sound * speed_of_sound / gamma; }

  auto pressure(auto density) const {
    return stiffness() * (to_the<gamma>(density / rest_density) - 1.0);
  }
  // Returns the speed of sound at a density [m/s], c0 (rho / rho_0)^((gamma - 1) / 2).
  double speed_of_sound_at(double density) const {
    return speed_of_sound * to_the<(gamma - 1) / 2>(density / rest_density);
  }
  // Returns the density at a pressure p > -B.
  double density(double pressure) const {
    return rest_density * std::pow(1.0 + pressure / stiffness(), 1.0 / gamma);
  }
  // Returns the energy [J/kg], with s = rho / rho_0: B / rho_0 ((s^(gamma - 1) - 1) / (gamma - 1) +
  // 1 / s - 1). Its terms nearly cancel near s = 1, so the double root at s = 1 is factored out.
  double energy(double density) const {
    const double s = density / rest_density, compression = s - 1.0;
    double rest = 1.0;
    for (int k = 2; k < gamma; ++k) rest = rest * s + k;
    return stiffness() / rest_density * compression * compression * rest / ((gamma - 1) * s);
  }
};

// Water: gamma = 7 (Monaghan 1994; Li et al. 2010, eq. 9).
struct Tait : PowerLawState<7> {
  static constexpr const char* name = "Tait equation of state, gamma = 7";
  using PowerLawState::PowerLawState;
};
// Equations of state between Tait's and the linear one.
struct CubicState : PowerLawState<3> {
  static constexpr const char* name = "power-law equation of state, gamma = 3";
  using PowerLawState::PowerLawState;
};
struct QuinticState : PowerLawState<5> {
  static constexpr const char* name = "power-law equation of state, gamma = 5";
  using PowerLawState::PowerLawState;
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
  double speed_of_sound_at(double) const { return speed_of_sound; }
  double density(double pressure) const {
    return rest_density + pressure / (speed_of_sound * speed_of_sound);
  }
  // Returns the energy [J/kg], with s = rho / rho_0: c0^2 (ln s + 1 / s - 1).
  double energy(double density) const {
    const double compression = density / rest_density - 1.0;
    return speed_of_sound * speed_of_sound *
           (std::log1p(compression) - compression / (1.0 + compression));
  }
};

}  // namespace slosh::sph

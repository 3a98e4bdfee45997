// A liquid far from all walls that a central force -Omega^2 r pulls to the middle of its box,
// instead of gravity. The force is a scheme's frame, so that the schemes of tanks need not know it.
#pragma once

#include "sph/schemes.hpp"

namespace slosh {

inline constexpr double angular_frequency = 1;  // Omega [rad/s]

struct CentralField : sph::TankWalls {
  double centre_x, centre_z;  // [m]

  sph::Vector2 apparent_gravity(double, double x, double z, double u, double w) const {
    sph::Vector2 sum{0, 0};
    pull(0, x, z, u, w, sum.x, sum.z);
    return sum;
  }
  template <class Number>
  void pull(double, Number x, Number z, Number, Number, Number& acceleration_x,
            Number& acceleration_z) const {
    acceleration_x -= angular_frequency * angular_frequency * (x - centre_x);
    acceleration_z -= angular_frequency * angular_frequency * (z - centre_z);
  }
};

struct CentralFrame {
  static constexpr const char* name = "central force -Omega^2 r about the middle of the box";
  using Tank = CentralField;
  using Motion = sph::SurgeMotion;
  static constexpr bool takes_roll = false;

  static Tank tank(const sph::Scene& scene, double) {
    return {{0, scene.tank_length, 0, scene.tank_height, 0, 0},
            0.5 * scene.tank_length,
            0.5 * scene.tank_height};
  }
};

// A choice of terms for a liquid that touches nothing.
template <class Choice>
struct FreeDrop : Choice {
  using Frame = CentralFrame;
  using Mirror = sph::NoMirror;
  using Solids = sph::NoSolids;
};

}  // namespace slosh

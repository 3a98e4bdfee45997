// A liquid far from all walls that a central force -Omega^2 r pulls to the middle of its box,
// instead of gravity. The force is a scheme's frame, so that the schemes of tanks need not know it.
#pragma once

#include "sph/compiled_terms.hpp"
#include "sph/schemes.hpp"

namespace slosh {

inline constexpr double angular_frequency = 1;  // Omega [rad/s]

struct CentralFrame {
  static constexpr const char* name = "central force -Omega^2 r about the middle of the box";
  static constexpr bool takes_roll = false, walls_roll = false, is_tanks = false;

  static sph::Tank tank(const sph::Scene& scene, double) {
    return {sph::TankWalls{0, scene.tank_length, 0, scene.tank_height, 0, 0},
            sph::InertialForces{.axis_x = 0.5 * scene.tank_length,
                                .axis_z = 0.5 * scene.tank_height,
                                .attraction = angular_frequency * angular_frequency}};
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

// A particle of a solid wall and its node, where the liquid's state is evaluated for it.
#pragma once

#include <cmath>

#include "sph/scene.hpp"
#include "sph/walls/line_of_sight.hpp"
#include "sph/walls/tank_walls.hpp"

namespace slosh::sph {

// What a reflection does to a velocity, as a symmetric matrix.
struct Turn {
  double xx = 1, xz = 0, zz = 1;

  // Returns the reflection that turns the component along a unit vector.
  static Turn along(double x, double z) { return {1 - 2 * x * x, -2 * x * z, 1 - 2 * z * z}; }
  static Turn both() { return {-1, 0, -1}; }
  // Returns the velocity v, relative to the earth, after its reflection in a wall that moves along
  // x at `wall` [m/s].
  Vector2 of(Vector2 v, double wall) const {
    return {(1 - xx) * wall + xx * v.x + xz * v.z, xz * (v.x - wall) + zz * v.z};
  }
};

struct SolidPlace {
  double x, z;            // in the tank [m]
  double node_x, node_z;  // in the liquid [m]
  Turn turn = {};         // of the velocity by the reflection
  bool in_obstacle = false;
  int face = no_face;     // of the thin obstacles, that it stands behind
  double cell_share = 1;  // its share of a lattice cell's volume
};

// Reflects a node that lies behind the tank's walls into the tank.
inline void fold_into_tank(SolidPlace& place, const Scene& scene) {
  const auto fold = [](double& at, double& turn, double length) {
    if (at > 0 && at < length) return;
    at = at <= 0 ? -at : 2 * length - at;
    turn = -turn;
  };
  fold(place.node_x, place.turn.xx, scene.tank_length);
  fold(place.node_z, place.turn.zz, scene.tank_height);
}

// Returns how many layers of particles reach `depth`.
inline int whole_layers(double depth, double dp) {
  return static_cast<int>(std::ceil(depth / dp - 1e-9));
}

}  // namespace slosh::sph

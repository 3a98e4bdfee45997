// A particle of a solid wall and its node, where the liquid's state is evaluated for it.
#pragma once

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

}  // namespace slosh::sph

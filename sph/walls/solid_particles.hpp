// Where the particles of solid walls and obstacles stand: layers as deep as the kernel reaches,
// fixed in the tank. Each has a node, its mirror image in the nearest face, where the liquid that
// faces it is looked up (Marrone et al. 2011, section 3; English et al. 2022, modified dynamic
// boundary conditions).
#pragma once

#include <cstdint>
#include <vector>

#include "sph/neighbours/particles.hpp"
#include "sph/simulation.hpp"
#include "sph/walls/tank_walls.hpp"

namespace slosh::sph {

struct SolidPlace {
  double x, z;            // in the tank [m]
  double node_x, node_z;  // in the liquid [m]
  bool turns_x, turns_z;  // which components of the velocity the reflection turns
};

// The layers of the scene's obstacles and, where `tank_walls`, of the tank's bottom, sides and
// roof, `depth` [m] deep, a particle spacing apart, half a spacing inside the faces. An obstacle
// that touches a wall is continued behind it, in place of the wall's own layers. Throws
// std::invalid_argument for an obstacle across which the liquid on its two sides would meet:
// thinner than `depth`.
std::vector<SolidPlace> solid_places(const Scene& scene, bool tank_walls, double depth);

// The obstacles on the lattice: edges moved to the nearest border between its cells, and continued
// behind the walls that they touch by the whole layers that reach `depth`.
std::vector<Rectangle> obstacles_on_lattice(const Scene& scene, double depth);

// Brings particles that have come into the obstacle back out through its nearest face, their normal
// velocity turned in the tank's frame, as ReflectingWall does at the tank's walls.
void expel(Particles& particles, const TankWalls& walls, const Rectangle& obstacle);

inline bool holds(const Rectangle& r, double x, double z) {
  return x > r.left && x < r.right && z > r.bottom && z < r.top;
}

}  // namespace slosh::sph

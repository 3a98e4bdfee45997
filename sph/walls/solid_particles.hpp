// The positions of the particles of solid walls and obstacles, in layers as deep as the kernel's
// support, fixed in the tank. Each has a node, its mirror image in the nearest face, at which the
// liquid's state is evaluated (Marrone et al. 2011, section 3; English et al. 2022, modified
// dynamic boundary conditions).
#pragma once

#include <cstdint>
#include <vector>

#include "sph/neighbours/particles.hpp"
#include "sph/scene.hpp"
#include "sph/walls/solid_place.hpp"
#include "sph/walls/tank_walls.hpp"

namespace slosh::sph {

// Returns the particles of the scene's obstacles and, where `tank_walls`, of the tank's bottom,
// sides and roof, or of its outline (outline_layers.hpp). They fill layers `depth` [m] deep, a
// particle spacing apart, from half a spacing inside the faces. Along the tank's walls each cell
// holds `along_walls` of them beside one another, of equal shares of its volume, and each cell of a
// corner the square of that number. An obstacle that touches a wall is continued behind it, in
// place of the wall's own layers. An obstacle thinner than `depth` has places behind each of its
// faces (thin_obstacles.hpp).
std::vector<SolidPlace> solid_places(const Scene& scene, bool tank_walls, double depth,
                                     int along_walls);

// Returns the obstacles with their edges moved to the nearest border between cells of the lattice.
// An obstacle that touches a wall is continued behind it by as many whole layers as reach `depth`.
// Throws std::invalid_argument for one with liquid on two sides that is thinner than a particle
// spacing, and for one that covers no cell.
std::vector<Rectangle> obstacles_on_lattice(const Scene& scene, double depth);

// Returns how many layers of particles reach `depth`.
int whole_layers(double depth, double particle_spacing);

// Reflects a node that lies behind the tank's walls into the tank.
void fold_into_tank(SolidPlace& place, const Scene& scene);

inline bool holds(const Rectangle& r, double x, double z) {
  return x > r.left && x < r.right && z > r.bottom && z < r.top;
}

// Returns a place in the obstacle with its mirror image in the obstacle's nearest face as its node.
// A face behind a wall of the tank does not count.
SolidPlace behind_nearest_face(double x, double z, const Rectangle& r, double tank_length,
                               double tank_height);

// Moves a particle to a place in the tank [m] and reverses its velocity relative to the tank along
// x or z.
template <class Tank>
void move_with_tank(Particles& p, std::size_t i, const Tank& tank, Vector2 place, bool turns_x,
                    bool turns_z) {
  const Vector2 wall = tank.wall_velocity(p.x[i], p.z[i]);
  const auto turn = [&](Vector2 normal) {
    p.turn_velocity(i, normal.x, normal.z, wall.x * normal.x + wall.z * normal.z);
  };
  if (turns_x) turn(tank.along_frame(1, 0));
  if (turns_z) turn(tank.along_frame(0, 1));
  const Vector2 to = tank.in_frame(place.x, place.z);
  p.x[i] = to.x;
  p.z[i] = to.z;
}

// Moves particles that have entered the obstacle back out through its nearest face and reverses
// their normal velocity in the tank's frame, as ReflectingWall does at the tank's walls. Returns
// how many it has moved.
template <class Tank>
std::size_t expel(Particles& p, const Tank& tank, const Rectangle& obstacle) {
  std::size_t expelled = 0;
#pragma omp parallel for schedule(static) reduction(+ : expelled)
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Vector2 at = tank.in_tank(p.x[i], p.z[i]);
    if (!holds(obstacle, at.x, at.z)) continue;
    ++expelled;
    const SolidPlace out =
        behind_nearest_face(at.x, at.z, obstacle, tank.length(), tank.tank_height());
    move_with_tank(p, i, tank, {out.node_x, out.node_z}, out.turn.xx < 0, out.turn.zz < 0);
  }
  return expelled;
}

}  // namespace slosh::sph

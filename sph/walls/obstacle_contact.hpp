// What happens to a particle that has entered an obstacle: it is moved back out through the nearest
// face. Of obstacles that are thinner than the kernel's support, thin_obstacles.hpp tells the face.
#pragma once

#include <cstddef>

#include "sph/neighbours/particles.hpp"
#include "sph/scene.hpp"
#include "sph/walls/solid_place.hpp"
#include "sph/walls/tank_walls.hpp"

namespace slosh::sph {

inline bool holds(const Rectangle& r, double x, double z) {
  return x > r.left && x < r.right && z > r.bottom && z < r.top;
}

// Returns a place in the obstacle with its mirror image in the obstacle's nearest face as its node.
// A face behind a wall of the tank does not count.
SolidPlace behind_nearest_face(double x, double z, const Rectangle& r, double tank_length,
                               double tank_height);

// Moves a particle to a place in the tank [m] and reverses its velocity relative to the tank along
// x or z.
void move_with_tank(Particles& p, std::size_t i, const Tank& tank, Vector2 place, bool turns_x,
                    bool turns_z);

// Moves particles that have entered the obstacle back out through its nearest face and reverses
// their normal velocity in the tank's frame, as ReflectingWall does at the tank's walls. Returns
// how many it has moved.
std::size_t expel(Particles& p, const Tank& tank, const Rectangle& obstacle);

}  // namespace slosh::sph

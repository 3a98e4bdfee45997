// Puts particles that have crossed a tank's outline back, as ReflectingWall does in a rectangle.
#pragma once

#include <cmath>

#include "sph/neighbours/particles.hpp"
#include "sph/walls/tank_outline.hpp"

namespace slosh::sph {

// Exchanges every particle that has crossed the outline with its mirror image in the outline's
// nearest point: its position is reflected, and the component of its velocity along the way back
// becomes 2 v_wall - v. Where the image is outside too, beyond a sharp corner, the particle is put
// just inside that point. Returns how many it has moved.
template <class Tank>
std::size_t confine_to(const TankOutline& outline, Particles& p, const Tank& tank) {
  std::size_t exchanged = 0;
#pragma omp parallel for schedule(static) reduction(+ : exchanged)
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Vector2 place = tank.in_tank(p.x[i], p.z[i]);
    if (outline.contains(place.x, place.z)) continue;
    const OutlinePoint wall = outline.nearest(place.x, place.z);
    if (!std::isfinite(place.x + place.z)) continue;  // the stability guard reports it
    ++exchanged;
    Vector2 back{2 * wall.at.x - place.x, 2 * wall.at.z - place.z};
    if (!outline.contains(back.x, back.z)) {
      const double inside = 1e-6 * (outline.top() - outline.bottom());
      const OutlinePoint opposite = outline.nearest(back.x, back.z);
      back = {opposite.at.x + inside * opposite.inward.x,
              opposite.at.z + inside * opposite.inward.z};
    }
    const Vector2 velocity = tank.wall_velocity(p.x[i], p.z[i]),
                  normal = tank.along_frame(wall.inward.x, wall.inward.z);
    p.turn_velocity(i, normal.x, normal.z, velocity.x * normal.x + velocity.z * normal.z);
    const Vector2 to = tank.in_frame(back.x, back.z);
    p.x[i] = to.x;
    p.z[i] = to.z;
  }
  return exchanged;
}

}  // namespace slosh::sph

#include "sph/walls/obstacle_contact.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace slosh::sph {

SolidPlace behind_nearest_face(double x, double z, const Rectangle& r, double tank_length,
                               double tank_height) {
  constexpr double none = std::numeric_limits<double>::infinity();
  const std::array<double, 4> depth{
      r.left < 0 ? none : x - r.left, r.right > tank_length ? none : r.right - x,
      r.bottom < 0 ? none : z - r.bottom, r.top > tank_height ? none : r.top - z};
  switch (std::min_element(depth.begin(), depth.end()) - depth.begin()) {
    case 0:
      return {x, z, 2 * r.left - x, z, Turn::along(1, 0)};
    case 1:
      return {x, z, 2 * r.right - x, z, Turn::along(1, 0)};
    case 2:
      return {x, z, x, 2 * r.bottom - z, Turn::along(0, 1)};
    default:
      return {x, z, x, 2 * r.top - z, Turn::along(0, 1)};
  }
}

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

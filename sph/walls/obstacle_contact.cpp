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

}  // namespace slosh::sph

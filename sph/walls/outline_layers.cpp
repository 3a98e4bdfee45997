#include "sph/walls/outline_layers.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace slosh::sph {
namespace {

constexpr double sharp = std::numbers::pi / 3;  // [rad] of the turn at a corner

// Returns by how much the outline turns from one side to the next, positive to the left [rad].
double turn_between(const OutlineSide& a, const OutlineSide& b) {
  return std::atan2(a.along.x * b.along.z - a.along.z * b.along.x,
                    a.along.x * b.along.x + a.along.z * b.along.z);
}

SolidPlace behind_corner(Vector2 at, Vector2 corner, double turn) {
  const double dx = at.x - corner.x, dz = at.z - corner.z, r = std::hypot(dx, dz);
  const Turn turned = turn >= sharp ? Turn::both() : Turn::along(dx / r, dz / r);
  return {at.x, at.z, corner.x - dx, corner.z - dz, turned};
}

SolidPlace behind_side(Vector2 at, const OutlineSide& side) {
  const double distance = side.distance_of(at);
  return {at.x, at.z, at.x - 2 * distance * side.normal.x, at.z - 2 * distance * side.normal.z,
          Turn::along(side.normal.x, side.normal.z)};
}

}  // namespace

std::vector<SolidPlace> outline_layers(const TankOutline& outline, double dp, double depth,
                                       int along_walls) {
  std::vector<SolidPlace> places;
  const std::vector<OutlineSide>& sides = outline.sides();
  const int layers = static_cast<int>(std::ceil(depth / dp - 1e-9));
  for (std::size_t k = 0; k < sides.size(); ++k) {
    const OutlineSide& side = sides[k];
    const double turn_before = turn_between(sides[(k + sides.size() - 1) % sides.size()], side),
                 turn_after = turn_between(side, sides[(k + 1) % sides.size()]);
    for (int layer = 0; layer < layers; ++layer) {
      const double behind = (layer + 0.5) * dp;
      const double begin = -behind * std::tan(0.5 * turn_before),
                   end = side.length + behind * std::tan(0.5 * turn_after);
      if (!(end > begin)) continue;
      const int count = std::max(1, static_cast<int>(std::round((end - begin) * along_walls / dp)));
      for (int i = 0; i < count; ++i) {
        const double along = begin + (end - begin) * (i + 0.5) / count;
        const Vector2 at{side.from.x + along * side.along.x - behind * side.normal.x,
                         side.from.z + along * side.along.z - behind * side.normal.z};
        SolidPlace place = along < 0             ? behind_corner(at, side.from, turn_before)
                           : along > side.length ? behind_corner(at, side.to, turn_after)
                                                 : behind_side(at, side);
        // What lies farther from the corner than the layers are deep is out of the liquid's reach.
        if (std::hypot(place.node_x - at.x, place.node_z - at.z) > 2 * layers * dp) continue;
        place.cell_share = (end - begin) / (count * dp);
        places.push_back(place);
      }
    }
  }
  places.shrink_to_fit();  // they stay as long as the run
  return places;
}

}  // namespace slosh::sph

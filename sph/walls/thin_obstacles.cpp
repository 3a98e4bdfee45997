#include "sph/walls/thin_obstacles.hpp"

#include <algorithm>
#include <cmath>

namespace slosh::sph {
namespace {

bool is_across_x(int side) { return side == left_side || side == right_side; }

// Whether there is liquid before a side: it is not behind a wall of the tank.
bool is_free(const Rectangle& r, int side, double tank_length, double tank_height) {
  if (side == left_side) return r.left > 0;
  if (side == right_side) return r.right < tank_length;
  return side == bottom_side ? r.bottom > 0 : r.top < tank_height;
}

bool contains(const Rectangle& r, Vector2 at) { return holds(r, at.x, at.z); }

void mirror_node(SolidPlace& place, const Rectangle& r, int side) {
  const Vector2 node = mirrored({place.node_x, place.node_z}, r, side);
  place.node_x = node.x;
  place.node_z = node.z;
  double& turn = is_across_x(side) ? place.turn.xx : place.turn.zz;
  turn = -turn;
}

// Mirrors the node in an obstacle, other than its own, that hides it from the face before it, or
// that is as thick as the support and covers this part of the face. What covers the face and is
// thin has liquid on both of its sides: a node in it sees both.
void fold_at_obstacles(SolidPlace& place, const LineOfSight& obstacles, double depth,
                       const Scene& scene) {
  const double length = scene.tank_length, height = scene.tank_height;
  const Vector2 node{place.node_x, place.node_z};
  // Just before the face, half way to the node.
  const Vector2 before_face{0.45 * place.x + 0.55 * node.x, 0.45 * place.z + 0.55 * node.z};
  for (const Rectangle& r : obstacles.rectangles()) {
    if (!contains(r, before_face)) continue;
    if (!contains(r, node) || is_thin(r, depth, length, height)) return;
    const int low = is_across_x(place.face % 4) ? bottom_side : left_side, high = low + 1;
    const double to_low = low == bottom_side ? node.z - r.bottom : node.x - r.left,
                 to_high = low == bottom_side ? r.top - node.z : r.right - node.x;
    const bool low_is_free = is_free(r, low, length, height),
               high_is_free = is_free(r, high, length, height);
    if (low_is_free || high_is_free)
      mirror_node(place, r, low_is_free && (!high_is_free || to_low < to_high) ? low : high);
    return;
  }
  if (const int face = obstacles.entered(before_face, node); face != no_face)
    mirror_node(place, obstacles.rectangles()[static_cast<std::size_t>(face / 4)], face % 4);
}

// The cells behind a face, counted from the rectangle's left bottom corner.
struct CellRange {
  int from, to;
};

// Returns the cells across the face's own direction, `layers` deep from the face.
CellRange behind(bool low, int count, int layers) {
  return low ? CellRange{0, layers} : CellRange{count - layers, count};
}
// Returns the cells along a face. They go on past a free end, where a segment through the face may
// lead, as far as the support reaches.
CellRange along(bool free_low, bool free_high, int count, int layers) {
  return {free_low ? -layers : 0, count + (free_high ? layers : 0)};
}

}  // namespace

void add_places_behind_faces(const Scene& scene, const std::vector<Rectangle>& obstacles,
                             double depth, std::vector<SolidPlace>& places) {
  const double dp = scene.particle_spacing, length = scene.tank_length, height = scene.tank_height;
  const int layers = whole_layers(depth, dp);
  const std::vector<Rectangle> thin = thin_obstacles(obstacles, depth, length, height);
  const LineOfSight all(obstacles);
  const auto is_in_thick = [&](double x, double z) {
    return std::any_of(obstacles.begin(), obstacles.end(), [&](const Rectangle& r) {
      return holds(r, x, z) && !is_thin(r, depth, length, height);
    });
  };
  for (std::size_t n = 0; n < thin.size(); ++n) {
    const Rectangle& r = thin[n];
    const int columns = static_cast<int>(std::max(1.0, std::round((r.right - r.left) / dp))),
              rows = static_cast<int>(std::max(1.0, std::round((r.top - r.bottom) / dp)));
    const double dx = (r.right - r.left) / columns, dz = (r.top - r.bottom) / rows;
    const auto free = [&](int side) { return is_free(r, side, length, height); };
    for (const int side : {left_side, right_side, bottom_side, top_side}) {
      if (!free(side)) continue;
      const CellRange in_x = is_across_x(side)
                                 ? behind(side == left_side, columns, layers)
                                 : along(free(left_side), free(right_side), columns, layers),
                      in_z = is_across_x(side)
                                 ? along(free(bottom_side), free(top_side), rows, layers)
                                 : behind(side == bottom_side, rows, layers);
      for (int row = in_z.from; row < in_z.to; ++row)
        for (int column = in_x.from; column < in_x.to; ++column) {
          const Vector2 at{r.left + (column + 0.5) * dx, r.bottom + (row + 0.5) * dz},
              node = mirrored(at, r, side);
          if (is_in_thick(at.x, at.z)) continue;
          SolidPlace place{at.x, at.z, node.x, node.z};
          place.turn = is_across_x(side) ? Turn::along(1, 0) : Turn::along(0, 1);
          place.in_obstacle = true;
          place.face = 4 * static_cast<int>(n) + side;
          fold_at_obstacles(place, all, depth, scene);
          fold_into_tank(place, scene);
          places.push_back(place);
        }
    }
  }
}

int face_run_into(const LineOfSight& sight, const Vector2* before, Vector2 now, Vector2 velocity,
                  double tank_length, double tank_height) {
  if (before) return sight.pierced(*before, now);
  const auto& rectangles = sight.rectangles();
  for (std::size_t n = 0; n < rectangles.size(); ++n) {
    const Rectangle& r = rectangles[n];
    if (!holds(r, now.x, now.z)) continue;
    // Far enough against the velocity is outside of the rectangle.
    const double speed = std::hypot(velocity.x, velocity.z),
                 way = std::hypot(r.right - r.left, r.top - r.bottom);
    const Vector2 earlier{now.x - way * velocity.x / speed, now.z - way * velocity.z / speed};
    const int face = speed > 0 ? LineOfSight({r}).entered(earlier, now) : no_face;
    const int first = 4 * static_cast<int>(n);
    if (face != no_face && is_free(r, face, tank_length, tank_height)) return first + face;
    const SolidPlace out = behind_nearest_face(now.x, now.z, r, tank_length, tank_height);
    if (out.turn.xx < 0) return first + (out.node_x < now.x ? left_side : right_side);
    return first + (out.node_z < now.z ? bottom_side : top_side);
  }
  return no_face;
}

}  // namespace slosh::sph

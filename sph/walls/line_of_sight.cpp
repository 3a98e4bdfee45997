#include "sph/walls/line_of_sight.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace slosh::sph {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double grazing = 1e-3;  // of the rectangle's thickness

// Where a line from `begin` in the direction `way` is between two planes: from `enter` to `leave`
// in units of `way`. It enters across the lower or the upper plane.
struct Slab {
  double enter, leave;
  bool from_below;

  Slab(double begin, double way, double low, double high) : from_below(way > 0) {
    if (way == 0) {
      const bool within = begin > low && begin < high;
      enter = within ? -infinity : infinity;
      leave = -enter;
      return;
    }
    const double to_low = (low - begin) / way, to_high = (high - begin) / way;
    enter = std::min(to_low, to_high);
    leave = std::max(to_low, to_high);
  }
};

struct Crossing {
  double enter = infinity, leave = infinity;  // shares of the segment
  int side = no_face;                         // entered
  bool opposite = false;                      // whether it would leave through the opposite side
  bool exists() const { return side != no_face; }
};

Crossing crossing_of(const Rectangle& r, Vector2 from, Vector2 to) {
  const double margin = grazing * std::min(r.right - r.left, r.top - r.bottom);
  const Slab x(from.x, to.x - from.x, r.left + margin, r.right - margin),
      z(from.z, to.z - from.z, r.bottom + margin, r.top - margin);
  const double enter = std::max(x.enter, z.enter), leave = std::min(x.leave, z.leave);
  if (!(enter < leave && enter < 1 && leave > 0)) return {};
  const bool by_x = x.enter > z.enter;
  const int side =
      by_x ? (x.from_below ? left_side : right_side) : (z.from_below ? bottom_side : top_side);
  return {enter, leave, side, by_x == (x.leave < z.leave)};
}

// -1, 0 or 1: before, between or beyond two lines.
int band(double at, double low, double high) { return at < low ? -1 : at > high ? 1 : 0; }

// The bands of a place about a rectangle, across its thickness and along its longer side.
struct Bands {
  int across, along;

  Bands(const Rectangle& r, Vector2 place) {
    across = band(place.x, r.left, r.right);
    along = band(place.z, r.bottom, r.top);
    if (!is_upright(r)) std::swap(across, along);
  }
  static bool is_upright(const Rectangle& r) { return r.right - r.left <= r.top - r.bottom; }
};

int side_of(bool across_x, int way) {
  if (across_x) return way < 0 ? left_side : right_side;
  return way < 0 ? bottom_side : top_side;
}

// Returns the side of the rectangle that hides the place, or no_face.
int hiding_side(const Rectangle& r, Vector2 from, Vector2 to) {
  const Bands a(r, from), b(r, to);
  const bool upright = Bands::is_upright(r);
  if (a.along == 0) {
    const bool hidden = a.across != 0 && b.along == 0 && b.across != a.across;
    return hidden ? side_of(upright, a.across) : no_face;
  }
  const bool beyond = a.across == 0 && b.along == -a.along;
  return b.across == 0 && (b.along == 0 || beyond) ? side_of(!upright, a.along) : no_face;
}

double distance(const Rectangle& r, Vector2 place) {
  return std::hypot(std::max({r.left - place.x, place.x - r.right, 0.0}),
                    std::max({r.bottom - place.z, place.z - r.top, 0.0}));
}

// A side of a rectangle, or no_face, and how far away it is, in any one unit.
struct Found {
  int side;
  double distance;
};

// Returns the nearest of the faces that find(rectangle) finds, or no_face.
template <class Find>
int nearest_face(const std::vector<Rectangle>& rectangles, const Find& find) {
  double nearest = infinity;
  int face = no_face;
  for (std::size_t n = 0; n < rectangles.size(); ++n) {
    const Found found = find(rectangles[n]);
    if (found.side == no_face || !(found.distance < nearest)) continue;
    nearest = found.distance;
    face = 4 * static_cast<int>(n) + found.side;
  }
  return face;
}

}  // namespace

int LineOfSight::entered(Vector2 from, Vector2 to) const {
  return nearest_face(rectangles_, [&](const Rectangle& r) -> Found {
    const Crossing crossing = crossing_of(r, from, to);
    return {crossing.side, crossing.enter};
  });
}

int LineOfSight::hiding_face(Vector2 from, Vector2 to) const {
  return nearest_face(rectangles_, [&](const Rectangle& r) -> Found {
    return {hiding_side(r, from, to), distance(r, from)};
  });
}

int LineOfSight::pierced(Vector2 from, Vector2 to) const {
  return nearest_face(rectangles_, [&](const Rectangle& r) -> Found {
    const Crossing crossing = crossing_of(r, from, to);
    const bool passed_a_corner = crossing.leave < 1 && !crossing.opposite;
    return {passed_a_corner ? no_face : crossing.side, crossing.enter};
  });
}

int LineOfSight::group(Vector2 place, double reach) const {
  int group = no_group;
  for (std::size_t n = 0; n < rectangles_.size(); ++n) {
    if (!(distance(rectangles_[n], place) < reach)) continue;
    if (group != no_group) return its_own_group;
    const Bands bands(rectangles_[n], place);
    group = 9 * static_cast<int>(n) + 3 * (bands.across + 1) + bands.along + 1;
  }
  return group;
}

bool is_thin(const Rectangle& r, double depth, double tank_length, double tank_height) {
  const bool free_x = r.left > 0 && r.right < tank_length;
  const bool free_z = r.bottom > 0 && r.top < tank_height;
  const double least = depth * (1 - 1e-9);
  return (free_x && r.right - r.left < least) || (free_z && r.top - r.bottom < least);
}

std::vector<Rectangle> thin_obstacles(const std::vector<Rectangle>& obstacles, double depth,
                                      double tank_length, double tank_height) {
  std::vector<Rectangle> thin;
  for (const Rectangle& r : obstacles)
    if (is_thin(r, depth, tank_length, tank_height)) thin.push_back(r);
  return thin;
}

Vector2 mirrored(Vector2 place, const Rectangle& r, int side) {
  if (side == left_side) return {2 * r.left - place.x, place.z};
  if (side == right_side) return {2 * r.right - place.x, place.z};
  return {place.x, 2 * (side == bottom_side ? r.bottom : r.top) - place.z};
}

}  // namespace slosh::sph

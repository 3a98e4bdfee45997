#include "openfoam_cases/outline/outline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "openfoam_cases/errors.hpp"

namespace slosh::openfoam {
namespace {

// Returns twice the area of the triangle a, b, c, positive where it is counter-clockwise.
double turn(Corner a, Corner b, Corner c) {
  return (b.x - a.x) * (c.z - a.z) - (c.x - a.x) * (b.z - a.z);
}

const Corner& next(const Polygon& polygon, std::size_t i) {
  return polygon[i + 1 == polygon.size() ? 0 : i + 1];
}

// Whether c, which lies on the line through a and b, is between them.
bool is_between(Corner a, Corner b, Corner c) {
  return std::min(a.x, b.x) <= c.x && c.x <= std::max(a.x, b.x) && std::min(a.z, b.z) <= c.z &&
         c.z <= std::max(a.z, b.z);
}

bool touch(Corner a, Corner b, Corner c, Corner d) {
  const double abc = turn(a, b, c), abd = turn(a, b, d), cda = turn(c, d, a), cdb = turn(c, d, b);
  if (((abc > 0) != (abd > 0)) && ((cda > 0) != (cdb > 0)) && abc != 0 && abd != 0 && cda != 0 &&
      cdb != 0)
    return true;
  return (abc == 0 && is_between(a, b, c)) || (abd == 0 && is_between(a, b, d)) ||
         (cda == 0 && is_between(c, d, a)) || (cdb == 0 && is_between(c, d, b));
}

// Neighbouring edges share a corner; they may not lie on each other.
void check_edges(const Polygon& outline) {
  const std::size_t count = outline.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Corner a = outline[i], b = next(outline, i), c = outline[(i + 2) % count];
    const double along = (b.x - a.x) * (c.x - b.x) + (b.z - a.z) * (c.z - b.z);
    if ((a.x == b.x && a.z == b.z) || (turn(a, b, c) == 0 && along < 0))
      throw std::invalid_argument(
          fmt::format("OpenFOAM tank: outline corner {}, counted from 0, at ({}, {}) m: expected "
                      "edges that have a length and "
                      "do not run back on themselves",
                      (i + 1) % count, b.x, b.z));
  }
  for (std::size_t i = 0; i < count; ++i) {
    const Corner a = outline[i], b = next(outline, i);
    for (std::size_t k = i + 2; k < count; ++k) {
      if (i == 0 && k + 1 == count) continue;
      if (touch(a, b, outline[k], next(outline, k)))
        throw std::invalid_argument(fmt::format(
            "OpenFOAM tank: outline edges {} and {}, counted from 0, cross or touch: expected a "
            "polygon that does not meet itself",
            i, k));
    }
  }
}

}  // namespace

// Places relative to the first corner keep round-off small.
double area_of(const Polygon& polygon) {
  double twice = 0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    twice += turn(polygon[0], polygon[i], polygon[i + 1]);
  return twice / 2;
}

Corner centroid_of(const Polygon& polygon) {
  const Corner origin = polygon[0];
  double x = 0, z = 0, sum = 0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    const Corner a = polygon[i], b = polygon[i + 1];
    const double weight = turn(origin, a, b);
    x += weight * (a.x + b.x - 2 * origin.x);
    z += weight * (a.z + b.z - 2 * origin.z);
    sum += weight;
  }
  return {origin.x + x / (3 * sum), origin.z + z / (3 * sum)};
}

bool is_inside(const Polygon& polygon, Corner place) {
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Corner a = polygon[i], b = next(polygon, i);
    if ((a.z > place.z) == (b.z > place.z)) continue;
    if (place.x < a.x + (place.z - a.z) / (b.z - a.z) * (b.x - a.x)) inside = !inside;
  }
  return inside;
}

Polygon right_of(const Polygon& polygon, Corner from, Corner to) {
  Polygon part;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Corner a = polygon[i], b = next(polygon, i);
    const double left_a = turn(from, to, a), left_b = turn(from, to, b);
    if (left_a <= 0) part.push_back(a);
    if ((left_a < 0 && left_b > 0) || (left_a > 0 && left_b < 0)) {
      const double share = left_a / (left_a - left_b);
      part.push_back({a.x + share * (b.x - a.x), a.z + share * (b.z - a.z)});
    }
  }
  return part;
}

double area_below(const Polygon& polygon, double z) {
  const auto [lowest, highest] = std::minmax_element(
      polygon.begin(), polygon.end(), [](const Corner& a, const Corner& b) { return a.z < b.z; });
  if (polygon.empty() || z <= lowest->z) return 0;
  if (z >= highest->z) return area_of(polygon);
  return area_of(right_of(polygon, {0, z}, {1, z}));
}

Chord chord_at(const Polygon& polygon, double z) {
  double length = 0, moment = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Corner a = polygon[i], b = next(polygon, i);
    if ((a.z > z) == (b.z > z)) continue;
    const double x = a.x + (z - a.z) / (b.z - a.z) * (b.x - a.x);
    const double sign = b.z > a.z ? 1 : -1;  // an edge that runs up ends the chord on the right
    length += sign * x;
    moment += sign * x * x / 2;
  }
  return {length, length > 0 ? moment / length : 0};
}

void check_outline(const SloshingTank& tank) {
  const Polygon& outline = tank.outline;
  require(outline.size() >= 3, "outline corners", static_cast<double>(outline.size()),
          "three or more");
  Corner least = outline[0], most = outline[0];
  for (const Corner& corner : outline) {
    require(std::isfinite(corner.x), "outline corner x", corner.x, "a finite place in m");
    require(std::isfinite(corner.z), "outline corner z", corner.z, "a finite place in m");
    least = {std::min(least.x, corner.x), std::min(least.z, corner.z)};
    most = {std::max(most.x, corner.x), std::max(most.z, corner.z)};
  }
  const auto require_side = [](const char* key, double value, double expected, double size) {
    require(std::abs(value - expected) <= 1e-9 * size, key, value,
            fmt::format("{} m, so that the tank's length and height are those of the rectangle "
                        "around the outline and the origin is its bottom left corner",
                        expected));
  };
  require_side("least x of the outline", least.x, 0, tank.length);
  require_side("largest x of the outline", most.x, tank.length, tank.length);
  require_side("least z of the outline", least.z, 0, tank.height);
  require_side("largest z of the outline", most.z, tank.height, tank.height);
  check_edges(outline);
  require(area_of(outline) > 0, "area of the outline", area_of(outline),
          "a positive number of m2, with the corners counter-clockwise (x to the right, z up)");
}

}  // namespace slosh::openfoam

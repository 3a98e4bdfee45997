#include "verification/case/shape/outline.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace slosh {
namespace {

const Corner& after(const Outline& outline, std::size_t corner) {
  return outline[(corner + 1) % outline.size()];
}

// Twice the area of the triangle a b c, positive where they count counter-clockwise.
double turn(Corner a, Corner b, Corner c) {
  return (b.x - a.x) * (c.z - a.z) - (b.z - a.z) * (c.x - a.x);
}

bool is_between(Corner a, Corner b, Corner c) {
  return c.x >= std::min(a.x, b.x) && c.x <= std::max(a.x, b.x) && c.z >= std::min(a.z, b.z) &&
         c.z <= std::max(a.z, b.z);
}

bool is_on(Corner a, Corner b, Corner place) {
  return turn(a, b, place) == 0 && is_between(a, b, place);
}

bool sides_meet(Corner a, Corner b, Corner c, Corner d) {
  if (is_on(a, b, c) || is_on(a, b, d) || is_on(c, d, a) || is_on(c, d, b)) return true;
  const auto parts = [](Corner p, Corner q, Corner one, Corner other) {
    return (turn(p, q, one) > 0) != (turn(p, q, other) > 0);
  };
  return parts(a, b, c, d) && parts(c, d, a, b);
}

}  // namespace

double signed_area(const Outline& outline) {
  double twice = 0;
  for (std::size_t i = 0; i < outline.size(); ++i)
    twice += outline[i].x * after(outline, i).z - after(outline, i).x * outline[i].z;
  return twice / 2;
}

std::optional<std::pair<std::size_t, std::size_t>> crossing_sides(const Outline& outline) {
  const std::size_t n = outline.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Corner &a = outline[i], &b = after(outline, i), &next = after(outline, (i + 1) % n);
    // A side without length, or a neighbour that runs back over this side.
    if (is_on(a, b, next) || is_on(b, next, a)) return std::pair{i, (i + 1) % n};
    for (std::size_t j = i + 2; j < n; ++j)
      if ((j + 1) % n != i && sides_meet(a, b, outline[j], after(outline, j)))
        return std::pair{i, j};
  }
  return std::nullopt;
}

bool is_in_one_piece_at_each_level(const Outline& outline) {
  int turns = 0;  // from rising to falling or back
  double last = 0;
  for (std::size_t i = 0; i < 2 * outline.size(); ++i) {
    const std::size_t corner = i % outline.size();
    const double rise = after(outline, corner).z - outline[corner].z;
    if (rise == 0) continue;
    if (i >= outline.size() && rise * last < 0) ++turns;
    last = rise;
  }
  return turns == 2;
}

Outline part_below(const Outline& outline, double level) {
  Outline part;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Corner &a = outline[i], &b = after(outline, i);
    if (a.z <= level) part.push_back(a);
    if ((a.z < level && b.z > level) || (a.z > level && b.z < level))
      part.push_back({a.x + (b.x - a.x) * (level - a.z) / (b.z - a.z), level});
  }
  return part;
}

double area_below(const Outline& outline, double level) {
  return signed_area(part_below(outline, level));
}

Extent extent_at(const Outline& outline, double level) {
  Extent extent{INFINITY, -INFINITY};
  const auto add = [&](double x) {
    extent.left = std::min(extent.left, x);
    extent.right = std::max(extent.right, x);
  };
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Corner &a = outline[i], &b = after(outline, i);
    if (a.z == level) add(a.x);
    if ((a.z < level && b.z > level) || (a.z > level && b.z < level))
      add(a.x + (b.x - a.x) * (level - a.z) / (b.z - a.z));
  }
  return extent;
}

bool contains(const Outline& outline, Corner place) {
  bool inside = false;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Corner &a = outline[i], &b = after(outline, i);
    if (is_on(a, b, place)) return true;
    if ((a.z > place.z) != (b.z > place.z) &&
        place.x < a.x + (b.x - a.x) * (place.z - a.z) / (b.z - a.z))
      inside = !inside;
  }
  return inside;
}

double side_length(const Outline& outline, std::size_t side) {
  const Corner &a = outline[side], &b = after(outline, side);
  return std::hypot(b.x - a.x, b.z - a.z);
}

PlaceOnOutline nearest_on(const Outline& outline, Corner place) {
  PlaceOnOutline nearest{0, 0, INFINITY, place};
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Corner &a = outline[i], &b = after(outline, i);
    const double length = side_length(outline, i);
    const double share = std::clamp(
        ((place.x - a.x) * (b.x - a.x) + (place.z - a.z) * (b.z - a.z)) / (length * length), 0.0,
        1.0);
    const Corner on{a.x + share * (b.x - a.x), a.z + share * (b.z - a.z)};
    const double distance = std::hypot(on.x - place.x, on.z - place.z);
    if (distance < nearest.distance) nearest = {i, share * length, distance, on};
  }
  return nearest;
}

Corner moved_along(const Outline& outline, Corner from, double distance) {
  const PlaceOnOutline start = nearest_on(outline, from);
  double perimeter = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) perimeter += side_length(outline, i);
  double rest = std::fmod(start.along + distance, perimeter);
  if (rest < 0) rest += perimeter;
  std::size_t side = start.side;
  for (; rest > side_length(outline, side); side = (side + 1) % outline.size())
    rest -= side_length(outline, side);
  const Corner &a = outline[side], &b = after(outline, side);
  const double share = rest / side_length(outline, side);
  return {a.x + share * (b.x - a.x), a.z + share * (b.z - a.z)};
}

bool is_symmetric(const Outline& outline) {
  const auto [left, right] =
      std::minmax_element(outline.begin(), outline.end(),
                          [](const Corner& one, const Corner& other) { return one.x < other.x; });
  const double sum = left->x + right->x, tolerance = 1e-9 * (right->x - left->x);
  return std::all_of(outline.begin(), outline.end(), [&](const Corner& corner) {
    return nearest_on(outline, {sum - corner.x, corner.z}).distance <= tolerance;
  });
}

Outline cylinder_outline(double diameter) {
  using std::numbers::pi;
  constexpr int corners = 128, quarter = corners / 4;
  const double radius =
      diameter / 2 * std::sqrt(2 * pi / (corners * std::sin(2 * pi / corners)));  // of the corners
  // From the middle, of the corner of this number from the lowest one: each is the image of others,
  // so that the polygon is symmetric to the last digit.
  const auto aside = [&](int number) {
    return 2 * number < quarter
               ? radius * std::sin((2 * number + 1) * pi / corners)
               : radius * std::cos((2 * (quarter - 1 - number) + 1) * pi / corners);
  };
  const auto down = [&](int number) { return aside(quarter - 1 - number); };
  const double middle = down(0);
  Outline outline;
  for (int i = 0; i < quarter; ++i) outline.push_back({middle + aside(i), middle - down(i)});
  for (int i = quarter - 1; i >= 0; --i) outline.push_back({middle + aside(i), middle + down(i)});
  for (int i = 0; i < quarter; ++i) outline.push_back({middle - aside(i), middle + down(i)});
  for (int i = quarter - 1; i >= 0; --i) outline.push_back({middle - aside(i), middle - down(i)});
  return outline;
}

}  // namespace slosh

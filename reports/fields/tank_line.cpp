#include "reports/fields/tank_line.hpp"

#include <algorithm>
#include <cmath>

namespace slosh::reports {
namespace {

constexpr double half_width = 0.75;  // [px], of the line
// A corner moves by less than this many half widths, however sharp it is.
constexpr double farthest = 4;

std::vector<TankCorner> corners_of(const FieldPanel& panel) {
  if (!panel.outline.empty()) return panel.outline;
  const double length = panel.tank_length, height = panel.tank_height;
  return {{0, 0}, {length, 0}, {length, height}, {0, height}};
}

// The unit normal that points out of the water, of a side of corners that count counter-clockwise.
TankCorner outward(const TankCorner& from, const TankCorner& to) {
  const double x = to.x - from.x, z = to.z - from.z, length = std::hypot(x, z);
  if (!(length > 0)) return {0, 0};
  return {z / length, -x / length};
}

}  // namespace

// Both sides at a corner move out by the same distance: the corner moves by (n1 + n2) / (1 + n1 n2)
// of it, whose length is the root of 2 / (1 + n1 n2).
std::vector<Pixel> tank_line(const FieldPanel& panel, const FieldLayout& layout) {
  const std::vector<TankCorner> corners = corners_of(panel);
  const double out = half_width / layout.scale;
  std::vector<Pixel> line;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const TankCorner &before = corners[(i + corners.size() - 1) % corners.size()], &at = corners[i],
                     &after = corners[(i + 1) % corners.size()];
    const TankCorner one = outward(before, at), other = outward(at, after);
    const double share =
        out / std::max(1 + one.x * other.x + one.z * other.z, 2 / (farthest * farthest));
    line.push_back(
        layout.in_cell(panel, at.x + share * (one.x + other.x), at.z + share * (one.z + other.z)));
  }
  return line;
}

}  // namespace slosh::reports

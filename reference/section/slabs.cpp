#include "reference/section/slabs.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "reference/require.hpp"

namespace slosh::reference {
namespace {

// Two heights or positions that differ by less than this share of the section's height are one:
// a cylinder's corners left and right are equally high but for the rounding of its sines.
constexpr double same = 1e-9;

double cross(const Corner& a, const Corner& b, const Corner& c) {
  return (b.x - a.x) * (c.z - a.z) - (b.z - a.z) * (c.x - a.x);
}

// Whether c, which lies on the line through a and b, lies between them.
bool between(const Corner& a, const Corner& b, const Corner& c) {
  return c.x >= std::min(a.x, b.x) && c.x <= std::max(a.x, b.x) && c.z >= std::min(a.z, b.z) &&
         c.z <= std::max(a.z, b.z);
}

bool meet(const Corner& a, const Corner& b, const Corner& c, const Corner& d) {
  const double to_c = cross(a, b, c), to_d = cross(a, b, d), to_a = cross(c, d, a),
               to_b = cross(c, d, b);
  if (((to_c > 0 && to_d < 0) || (to_c < 0 && to_d > 0)) &&
      ((to_a > 0 && to_b < 0) || (to_a < 0 && to_b > 0))) {
    return true;
  }
  return (to_c == 0 && between(a, b, c)) || (to_d == 0 && between(a, b, d)) ||
         (to_a == 0 && between(c, d, a)) || (to_b == 0 && between(c, d, b));
}

struct Extent {
  double lowest, highest;
};

Extent checked_extent(const Section& section, std::string_view where) {
  const auto& outline = section.outline;
  const std::size_t count = outline.size();
  require(count >= 3, where, "number of corners", count, "3 or more");
  Extent extent{outline[0].z, outline[0].z};
  double twice_area = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const Corner &here = outline[i], &next = outline[(i + 1) % count];
    require(std::isfinite(here.x) && std::isfinite(here.z), where, fmt::format("corner {}", i + 1),
            fmt::format("({}, {})", here.x, here.z), "a finite position, m");
    require(here.x != next.x || here.z != next.z, where, fmt::format("corner {}", i + 1),
            fmt::format("({}, {})", here.x, here.z), "a position other than the next corner's");
    extent.lowest = std::min(extent.lowest, here.z);
    extent.highest = std::max(extent.highest, here.z);
    twice_area += (here.x - outline[0].x) * (next.z - outline[0].z) -
                  (here.z - outline[0].z) * (next.x - outline[0].x);
  }
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = i + 2; j < count; ++j) {
      if (i == 0 && j + 1 == count) continue;  // these two edges share the first corner
      require(!meet(outline[i], outline[i + 1], outline[j], outline[(j + 1) % count]), where,
              "edges that meet", fmt::format("{} and {}", i + 1, j + 1),
              "an outline that does not cross or touch itself");
    }
  }
  require(twice_area > 0, where, "area", twice_area / 2,
          "corners in counter-clockwise order, with an area > 0 m2");
  const double height = extent.highest - extent.lowest;
  require(section.fill_depth > same * height && section.fill_depth < height, where, "fill depth",
          section.fill_depth,
          fmt::format("a depth between 0 and the section's height, {} m", height));
  require(section.gravity > 0 && std::isfinite(section.gravity), where, "gravity", section.gravity,
          "an acceleration > 0 m/s2");
  require(section.density > 0 && std::isfinite(section.density), where, "liquid density",
          section.density, "a density > 0 kg/m3");
  return extent;
}

struct Edge {
  Corner lower, upper;
  double at(double z) const {
    return lower.x + (upper.x - lower.x) * ((z - lower.z) / (upper.z - lower.z));
  }
};

// Returns the edges that cross a height, from the left to the right.
std::vector<Edge> edges_across(const std::vector<Corner>& outline, double z) {
  std::vector<Edge> edges;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    Corner lower = outline[i], upper = outline[(i + 1) % outline.size()];
    if (lower.z > upper.z) std::swap(lower, upper);
    if (lower.z < z && z < upper.z) edges.push_back({lower, upper});
  }
  std::sort(edges.begin(), edges.end(),
            [z](const Edge& a, const Edge& b) { return a.at(z) < b.at(z); });
  return edges;
}

// The potential near a corner of the interior angle beta behaves as r^(pi/beta), and in a right
// angle that of a turning tank as r^2 log r. Where the wall turns by less than 9 degrees the
// singularity is too weak to be seen, and a cylinder of 64 corners or more needs no grading.
bool singular(double angle) {
  constexpr double least_turn = 0.16;
  return std::abs(angle - std::numbers::pi) > least_turn;
}

double left_direction(const Slab& slab) {
  return std::atan2(slab.top - slab.bottom, slab.left_top - slab.left_bottom);
}
double right_direction(const Slab& slab) {
  return std::atan2(slab.top - slab.bottom, slab.right_top - slab.right_bottom);
}

bool singular_at_bottom(const Slab& slab) {
  const double left = left_direction(slab), right = right_direction(slab);
  if (slab.pointed()) return singular(left - right);
  return singular(left) || singular(std::numbers::pi - right);
}

bool singular_between(const Slab& below, const Slab& above) {
  return singular(std::numbers::pi + left_direction(above) - left_direction(below)) ||
         singular(std::numbers::pi - right_direction(above) + right_direction(below));
}

}  // namespace

double Slab::half_width(double z) const {
  return (right_bottom - left_bottom) / 2 + half_width_slope() * (z - bottom);
}
double Slab::middle(double z) const {
  return (left_bottom + right_bottom) / 2 + middle_slope() * (z - bottom);
}
double Slab::half_width_slope() const {
  return (right_top - left_top - right_bottom + left_bottom) / (2 * (top - bottom));
}
double Slab::middle_slope() const {
  return (right_top + left_top - right_bottom - left_bottom) / (2 * (top - bottom));
}

std::vector<Slab> slabs_of(const Section& section, std::string_view where) {
  const auto [lowest, highest] = checked_extent(section, where);
  const double surface = lowest + section.fill_depth, tolerance = same * (highest - lowest);
  std::vector<double> corners{surface};
  for (const Corner& corner : section.outline) {
    if (corner.z < surface) corners.push_back(corner.z);
  }
  std::sort(corners.begin(), corners.end());
  std::vector<double> heights;
  for (const double z : corners) {
    if (heights.empty() || z > heights.back() + tolerance) heights.push_back(z);
  }
  heights.back() = surface;

  std::vector<Slab> slabs;
  for (std::size_t k = 0; k + 1 < heights.size(); ++k) {
    const double bottom = heights[k], top = heights[k + 1];
    const auto edges = edges_across(section.outline, (bottom + top) / 2);
    require(edges.size() == 2, where, "number of walls",
            fmt::format("{} at z = {} m", edges.size(), (bottom + top) / 2),
            "2 at every height below the still surface");
    Slab slab{bottom,          top, edges[0].at(bottom), edges[0].at(top), edges[1].at(bottom),
              edges[1].at(top)};
    if (k == 0 && slab.right_bottom - slab.left_bottom < tolerance) {
      slab.left_bottom = slab.right_bottom = (slab.left_bottom + slab.right_bottom) / 2;
    } else if (k > 0) {
      // What an edge's slope makes of the tolerance in z is no ledge.
      const double reach =
          10 * tolerance * (1 + std::abs(slab.middle_slope()) + std::abs(slab.half_width_slope()));
      const double ledge = std::max(std::abs(slab.left_bottom - slabs.back().left_top),
                                    std::abs(slab.right_bottom - slabs.back().right_top));
      require(ledge <= reach, where, "horizontal ledge",
              fmt::format("{} m wide at z = {} m", ledge, bottom),
              "no horizontal edge between the bottom and the still surface");
    }
    slabs.push_back(slab);
  }
  return slabs;
}

std::vector<Slab> graded(const std::vector<Slab>& slabs, const Grading& grading) {
  std::vector<Slab> pieces;
  for (std::size_t k = 0; k < slabs.size(); ++k) {
    const Slab& slab = slabs[k];
    const bool last = k + 1 == slabs.size();
    std::vector<double> cuts{slab.bottom, slab.top};
    const double height = slab.top - slab.bottom;
    const auto cut = [&](double from, double sign, const std::vector<double>& distances) {
      for (const double distance : distances) {
        if (distance < 0.9 * height) cuts.push_back(from + sign * distance);
      }
    };
    if (k == 0 ? singular_at_bottom(slab) : singular_between(slabs[k - 1], slab)) {
      cut(slab.bottom, 1, grading.to_corner);
    }
    if (last) {
      cut(slab.top, -1, grading.to_surface);
    } else if (singular_between(slab, slabs[k + 1])) {
      cut(slab.top, -1, grading.to_corner);
    }
    std::sort(cuts.begin(), cuts.end());
    // Two cuts from opposite ends may coincide.
    cuts.erase(std::unique(cuts.begin(), cuts.end(),
                           [&](double a, double b) { return b - a < 1e-6 * height; }),
               cuts.end());
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
      const double bottom = cuts[i], top = cuts[i + 1];
      const auto wall = [&](double z, double sign) {
        return slab.middle(z) + sign * slab.half_width(z);
      };
      Slab piece{bottom, top, wall(bottom, -1), wall(top, -1), wall(bottom, 1), wall(top, 1)};
      if (i == 0) piece.left_bottom = slab.left_bottom, piece.right_bottom = slab.right_bottom;
      pieces.push_back(piece);
    }
  }
  return pieces;
}

}  // namespace slosh::reference

// The liquid at rest in a section, cut at the heights of the corners into slabs, each of them a
// trapezoid or, at a pointed bottom, a triangle. The slabs are cut further towards the
// still surface and towards corners in which the potential is singular.
#pragma once

#include <string_view>
#include <vector>

#include "reference/section/section.hpp"

namespace slosh::reference {

// A slab between two heights, with walls that are straight lines.
struct Slab {
  double bottom, top;                                     // heights [m]
  double left_bottom, left_top, right_bottom, right_top;  // the walls' x at these heights [m]

  // Half the width and the middle, at a height inside the slab.
  double half_width(double z) const;
  double middle(double z) const;
  double half_width_slope() const;  // d half_width / dz
  double middle_slope() const;
  // At a pointed bottom the slab is a triangle.
  bool pointed() const { return left_bottom == right_bottom; }
};

// Returns the slabs between the corners' heights from the lowest to the still surface. Throws
// std::invalid_argument, which names `where`, for fewer than three corners, a position that is not
// finite, an outline that crosses itself or runs clockwise, a fill depth that does not lie between
// 0 and the section's height, a gravity or density that is not positive, and a section that a
// horizontal line cuts in more than two points, or along a ledge, below the still surface.
std::vector<Slab> slabs_of(const Section& section, std::string_view where);

// Returns the slabs cut further, at `to_surface` [m] below the still surface, so that short waves
// are resolved, and at `to_corner` above and below each height at which a wall turns by more than 9
// degrees, where the potential is singular. Distances above 0.9 of the slab's height are left out.
struct Grading {
  std::vector<double> to_surface, to_corner;
};
std::vector<Slab> graded(const std::vector<Slab>& slabs, const Grading& grading);

}  // namespace slosh::reference

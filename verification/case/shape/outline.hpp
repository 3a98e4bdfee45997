// The outline of a tank that is no rectangle: a closed polygon of corners [m]. The corners count
// counter-clockwise, and the last one is joined to the first.
//
// Its area is half the sum of x_i z_(i+1) - x_(i+1) z_i over the sides (the shoelace formula), and
// that below a level is the area of what the level cuts off.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "verification/case/case_definition.hpp"

namespace slosh {

using Outline = std::vector<Corner>;

// [m2], negative for corners that count clockwise.
double signed_area(const Outline& outline);

// Returns the numbers of two sides that meet elsewhere than as neighbours at their corner, if there
// are any; the side 0 runs from the first corner to the second. A polygon without them is simple.
std::optional<std::pair<std::size_t, std::size_t>> crossing_sides(const Outline& outline);

// Whether each horizontal line meets the inside of a simple polygon in one piece, so that liquid
// below a level is one body under one surface. Level sides are allowed.
bool is_in_one_piece_at_each_level(const Outline& outline);

// The corners of what lies below a level, and its area [m2]. The polygon is simple.
Outline part_below(const Outline& outline, double level);
double area_below(const Outline& outline, double level);

struct Extent {
  double left, right;  // [m]
  double length() const { return right - left; }
};

// Where a level meets the polygon, its sides included. The level meets it.
Extent extent_at(const Outline& outline, double level);

// Whether the place is inside the polygon or on it.
bool contains(const Outline& outline, Corner place);

// A place on the outline: on which side, which runs from the corner of this number to the next, and
// how far from that corner.
struct PlaceOnOutline {
  std::size_t side;
  double along;     // [m], from the side's first corner
  double distance;  // [m], from the place that was asked for
  Corner place;
};

PlaceOnOutline nearest_on(const Outline& outline, Corner place);

double side_length(const Outline& outline, std::size_t side);  // [m]

// Returns the place that lies `distance` further on the outline, counter-clockwise where it is
// positive. The first place is the nearest on the outline.
Corner moved_along(const Outline& outline, Corner from, double distance);

// Whether it is its own image in its vertical middle line, to within 1e-9 of its length.
bool is_symmetric(const Outline& outline);

// Returns the outline of a lying cylinder: a regular polygon of 128 corners with a level side at
// the bottom, whose area is that of the circle, so that a fill depth holds the right amount of
// liquid. Its length and height are 0.9999 diameters. It begins at x = 0 and z = 0.
Outline cylinder_outline(double diameter);

}  // namespace slosh

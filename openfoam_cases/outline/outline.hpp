// Areas of polygons, and of their parts below a level. A polygon's corners are in metres and
// counter-clockwise with x to the right and z up. The area is Gauss's formula,
//   A = 1/2 sum (x_i z_i+1 - x_i+1 z_i),
// and the part on one side of a line is that of Sutherland and Hodgman (1974). Where this part
// consists of several pieces, edges along the line connect them, which add nothing to its area.
#pragma once

#include <vector>

#include "openfoam_cases/sloshing_tank.hpp"

namespace slosh::openfoam {

using Polygon = std::vector<Corner>;

// Returns the area [m2], negative where the corners are clockwise, and 0 below three corners.
double area_of(const Polygon& polygon);

// Returns the centroid [m] of a polygon whose area is not zero.
Corner centroid_of(const Polygon& polygon);

// Returns whether the place lies inside. On an edge either answer is possible.
bool is_inside(const Polygon& polygon, Corner place);

// Returns the part to the right of the line from one place to another one, which is the part below
// where x grows along the line.
Polygon right_of(const Polygon& polygon, Corner from, Corner to);

// Returns the area [m2] of the part below the level z [m].
double area_below(const Polygon& polygon, double z);

// The polygon's chord at the level z [m]: its length, and the middle of it, both [m]. Where there
// are several chords it is their sum and their common middle. The middle is meaningless where the
// length is zero.
struct Chord {
  double length, middle;
};
Chord chord_at(const Polygon& polygon, double z);

// Throws std::invalid_argument unless the tank's outline is a closed simple polygon of three or
// more corners, counter-clockwise, and the rectangle around it is [0, length] x [0, height], to
// 1e-9 of both.
void check_outline(const SloshingTank& tank);

}  // namespace slosh::openfoam

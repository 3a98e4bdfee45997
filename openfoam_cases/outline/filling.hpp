// How high liquid stands in a room of polygons, for an area of liquid below a horizontal level. The
// room's width changes linearly with the height between two corners, so that the area is a
// quadratic function of the level there, which is inverted exactly.
#pragma once

#include <vector>

#include "openfoam_cases/outline/outline.hpp"

namespace slosh::openfoam {

class Filling {
 public:
  Filling() = default;  // of a room that has no area
  // The polygons do not overlap.
  explicit Filling(const std::vector<Polygon>& room);

  double area() const { return areas_.empty() ? 0 : areas_.back(); }  // [m2], of the whole room

  // Returns the level [m] below which the room holds this area [m2]; the room's lowest place for
  // less than nothing, and its highest place for more than the whole.
  double level(double area) const;

 private:
  std::vector<double> heights_, areas_;  // of the corners, ascending, and of the room below them
  std::vector<double> widths_;           // of the room just above each height but the last
};

}  // namespace slosh::openfoam

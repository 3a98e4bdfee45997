// The solid particles behind a tank's outline: layers a spacing apart, parallel to its sides, from
// half a spacing behind them. The layers of neighbouring sides meet on the line that halves their
// angle, so that the particles' volumes fill the space behind the walls.
#pragma once

#include <vector>

#include "sph/walls/solid_place.hpp"
#include "sph/walls/tank_outline.hpp"

namespace slosh::sph {

// Returns the places of the layers down to `depth` [m], `along_walls` of them in each spacing dp
// along a side. The node of a place behind a side is its mirror image in that side. The node of a
// place behind a corner is its image in the corner's point. It turns the velocity's component from
// the corner, or where the corner turns by 60 degrees or more both components, as in the corner of
// a rectangle.
std::vector<SolidPlace> outline_layers(const TankOutline& outline, double dp, double depth,
                                       int along_walls);

}  // namespace slosh::sph

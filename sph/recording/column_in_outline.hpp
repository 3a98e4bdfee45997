// The free surface at a gauge in a tank that is not rectangular.
#pragma once

#include <vector>

#include "sph/neighbours/particles.hpp"
#include "sph/walls/tank_outline.hpp"

namespace slosh::sph {

// The column of liquid in the window of free_surface.hpp about a place. Beyond the ends of the
// still surface the liquid is continued by its mirror image. The surface's height is that of a
// level liquid in the tank with as much in the column.
class ColumnInOutline {
 public:
  // `x` is measured from the left wall, and `spacing` is that of the particles [m].
  ColumnInOutline(const TankOutline& outline, double fill_depth, double x, double spacing);

  // Returns the surface's elevation above the still level [m], at most up to the tank's top.
  double elevation(const Particles& particles) const;

 private:
  // Returns the sum of the window over a place and its two images.
  double weight(double x) const;

  double x_, fill_depth_, step_, scale_;  // [m], [m], [m], [1/m] of the window
  TankOutline::Extent still_;
  std::vector<double> depths_;  // of liquid in the column that stands at k step_
};

}  // namespace slosh::sph

// Tanks whose sections are polygons.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "openfoam_cases/tests/small_tank.hpp"

namespace slosh::openfoam {

// Returns a prismatic tank of 1 x 0.8 m with chamfers of 45 degrees, at rest. Its cells of 0.025 m
// are cut in no special place, and the level lies inside a row.
inline SloshingTank chamfered_tank(double lower_chamfer = 0.13) {
  SloshingTank tank = still_tank();
  const double c = lower_chamfer;
  tank.length = 1;
  tank.height = 0.8;
  tank.fill_depth = 0.31;
  tank.cells_x = 40;
  tank.cells_z = 32;
  tank.outline = {{c, 0},      {1 - c, 0},  {1, c},    {1, 0.57},
                  {0.77, 0.8}, {0.23, 0.8}, {0, 0.57}, {0, c}};
  tank.gauges = {{"left", 0.01}, {"chamfer", 0.07}, {"middle", 0.5}, {"right", 0.99}};
  return tank;
}

// Returns a lying cylinder of 1 m diameter, as a polygon with 128 corners, at rest.
inline SloshingTank lying_cylinder(double fill_depth = 0.5, int cells = 40) {
  SloshingTank tank = still_tank();
  tank.length = tank.height = 1;
  tank.fill_depth = fill_depth;
  tank.cells_x = tank.cells_z = cells;
  for (int i = 0; i < 128; ++i) {
    const double angle = 2 * std::numbers::pi * i / 128;
    tank.outline.push_back({0.5 + 0.5 * std::cos(angle), 0.5 + 0.5 * std::sin(angle)});
  }
  tank.gauges = {{"left", 0.02}, {"middle", 0.5}, {"right", 0.98}};
  return tank;
}

// Returns a tank of 1 x 0.6 m whose side walls lean outward, at rest.
inline SloshingTank inclined_tank() {
  SloshingTank tank = still_tank();
  tank.length = 1;
  tank.height = 0.6;
  tank.fill_depth = 0.31;
  tank.cells_x = 37;
  tank.cells_z = 23;
  tank.outline = {{0.2, 0}, {0.8, 0}, {1, 0.6}, {0, 0.6}};
  tank.gauges = {{"middle", 0.5}, {"beside", 0.89}};
  return tank;
}

}  // namespace slosh::openfoam

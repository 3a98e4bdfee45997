// A tank whose cross-section is any simple polygon, partly filled, for linear potential flow: a
// chamfered prism, a lying cylinder with many corners, a hopper.
//
// Every function of this folder takes and returns positions in the OUTLINE'S coordinates, fixed in
// the tank: x to the right and z up, in metres, from whichever origin the corners have. For corners
// as a case file gives them, x is measured from the left end and z from the lowest point. The still
// surface lies at the height of the lowest corner plus the fill depth.
#pragma once

#include <vector>

namespace slosh::reference {

struct Corner {
  double x, z;  // [m]
};

struct Section {
  std::vector<Corner> outline;  // counter-clockwise, each corner once
  double fill_depth;            // of the still surface above the lowest corner [m]
  double gravity;               // [m/s2]
  double density;               // of the liquid [kg/m3]
};

}  // namespace slosh::reference

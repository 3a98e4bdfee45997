// The liquid of a run at one moment: the input of every comparison of fields.
#pragma once

#include <vector>

namespace slosh {

// The liquid at one moment, as rectangles of equal size: the particles, or the cells that are at
// least half liquid.
struct FieldSnapshot {
  double time;                                 // [s]
  double width, height;                        // of a rectangle [m]
  std::vector<double> x, z;                    // middles, from the tank's bottom left corner [m]
  std::vector<double> velocity_x, velocity_z;  // against the tank, along its axes [m/s]
  std::vector<double> pressure;                // above the gas's [Pa]
};

}  // namespace slosh

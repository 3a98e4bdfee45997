// The tank that every reference solution describes, the gas above the liquid, and how the liquid
// starts. In a rectangular tank this library counts x from the tank's CENTRE, which its formulas
// need, and z from the still surface. Case files, results and the SPH library count from the left
// wall and from the bottom: x_from_centre = x_from_left - length / 2. In the polygons of section/
// the library has the outline's own coordinates, from the left end.
#pragma once

namespace slosh::reference {

// A rectangular tank, partly filled.
struct Tank {
  double length, fill_depth;  // [m]
  double gravity;             // [m/s2]
  double density;             // of the liquid [kg/m3]
};

// The gas between the still surface and the roof, for two-layer theory.
struct Gas {
  double density;  // [kg/m3]
  double height;   // of the roof above the still surface [m]
};

// The frame in which the liquid is at rest at t = 0: the earth's, in which the tank moves off at
// its initial velocity, or the tank's.
enum class Start { earth, tank };

// X(t) = amplitude sin(angular_frequency t + phase).
struct SineSurge {
  double amplitude;          // [m]
  double angular_frequency;  // [rad/s]
  double phase = 0;          // [rad]
};

}  // namespace slosh::reference

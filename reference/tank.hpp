// The tank that every reference solution describes, the gas above the liquid, and how the liquid
// starts.
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

// The tank's motion as functions of time, which every solver and reference takes from a case's
// definition: the surge X(t) and the roll theta(t). Each is twice differentiable, and its
// derivatives are exact:
//   sine    A r(s) sin(omega t), s = t / (ramp_periods 2 pi / omega), with the ramp
//           r(s) = s^3 (10 - 15 s + 6 s^2), 0 below and 1 above (the quintic "smoothstep" of K.
//           Perlin, Improving Noise, 2002: first and second derivatives vanish at both ends); r = 1
//           without a ramp
//   table   the cubic spline through its points (cubic_spline.hpp); valid from 0 to the last time
//   none    0
#pragma once

#include <functional>
#include <optional>

#include "verification/case/case_definition.hpp"

namespace slosh {

struct SurgeMotion {
  std::function<double(double)> displacement;  // X(t) [m]
  std::function<double(double)> velocity;      // X'(t) [m/s]
  std::function<double(double)> acceleration;  // X''(t) [m/s2]
};

// A rotation about an axis fixed to the tank, positive counter-clockwise.
struct RollMotion {
  std::function<double(double)> angle;         // theta(t) [rad]
  std::function<double(double)> rate;          // theta'(t) [rad/s]
  std::function<double(double)> acceleration;  // theta''(t) [rad/s2]
  double axis_x, axis_z;                       // [m] from the left wall and from the bottom
};

SurgeMotion surge_motion(const CaseDefinition& definition);

// Returns nullopt for a tank that does not roll.
std::optional<RollMotion> roll_motion(const CaseDefinition& definition);

// Returns the angular frequency of the forcing [rad/s]: the one that the case declares, or that of
// the sines. Returns zero for a still tank, for a table and for two sines of different frequencies.
double forcing_frequency(const CaseDefinition& definition);

}  // namespace slosh

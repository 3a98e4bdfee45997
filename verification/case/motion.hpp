// The tank's motion as functions of time, made from a case's definition: what each solver and
// reference is handed. The surge X(t) and the roll theta(t), each twice differentiable, each
// derivative exact:
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

// About an axis that the tank carries, positive counter-clockwise.
struct RollMotion {
  std::function<double(double)> angle;         // theta(t) [rad]
  std::function<double(double)> rate;          // theta'(t) [rad/s]
  std::function<double(double)> acceleration;  // theta''(t) [rad/s2]
  double axis_x, axis_z;                       // [m] from the left wall and from the bottom
};

SurgeMotion surge_motion(const CaseDefinition& definition);

// None of a tank that does not roll.
std::optional<RollMotion> roll_motion(const CaseDefinition& definition);

// The forcing's angular frequency [rad/s]: the one that the case declares, or else the sines'. Zero
// where there is none: of a tank that stands, of a table, of two sines that differ.
double forcing_frequency(const CaseDefinition& definition);

}  // namespace slosh

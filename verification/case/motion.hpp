// The tank's motion as functions of time, which every solver and reference takes from a case's
// definition: the surge X(t) and the roll theta(t). Each is twice differentiable, and its
// derivatives are exact:
//   sine    A r(s) sin(omega t + phase), s = t / (ramp_periods 2 pi / omega), with the ramp
//           r(s) = s^3 (10 - 15 s + 6 s^2), 0 below and 1 above (the quintic "smoothstep" of K.
//           Perlin, Improving Noise, 2002: first and second derivatives vanish at both ends); r = 1
//           without a ramp
//   sines   the sum of such sines, each with its own ramp
//   table   the cubic spline through its points (cubic_spline.hpp); valid from 0 to the last time
//   none    0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

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

// Returns the sines whose sum the motion is; none for a table.
std::vector<SineMotion> sines_of(const MotionHistory& history);

SurgeMotion surge_motion(const CaseDefinition& definition);

// Returns nullopt for a tank that does not roll.
std::optional<RollMotion> roll_motion(const CaseDefinition& definition);

// The response of the liquid at one frequency of the motion.
struct ForcedMode {
  std::string name;
  double angular_frequency;  // [rad/s]
};

// Returns one mode for each frequency of the motion: those of the surge's sines, then those of the
// roll's; a table has the one that the case declares, if it does. A single one is "forced", several
// are "forced_1", "forced_2", ... A still tank has none.
std::vector<ForcedMode> forced_modes(const CaseDefinition& definition);

// Whether a mode's name is that of a forced mode.
bool is_forced(const std::string& mode);

// Returns the angular frequency of the forcing [rad/s], or zero where it has none or several.
double forcing_frequency(const CaseDefinition& definition);

}  // namespace slosh

// The tank's horizontal motion as functions of time, made from a case's definition: what each
// solver and reference is handed. Twice differentiable, each derivative exact:
//   still   X(t) = 0
//   sine    X(t) = A r(s) sin(omega t), s = t / (ramp_periods 2 pi / omega), with the ramp
//           r(s) = s^3 (10 - 15 s + 6 s^2), 0 below and 1 above (the quintic "smoothstep" of K.
//           Perlin, Improving Noise, 2002: first and second derivatives vanish at both ends); r = 1
//           without a ramp
//   table   the cubic spline through its points (cubic_spline.hpp); valid from 0 to the last time
#pragma once

#include <functional>

#include "verification/case_file/case_definition.hpp"
#include "verification/case_file/case_file_error.hpp"

namespace slosh {

struct SurgeMotion {
  std::function<double(double)> displacement;  // X(t) [m]
  std::function<double(double)> velocity;      // X'(t) [m/s]
  std::function<double(double)> acceleration;  // X''(t) [m/s2]
};

// Throws CaseFileError for a roll, which no solver takes yet.
SurgeMotion surge_motion(const CaseDefinition& definition);

// The forcing's angular frequency [rad/s]; zero where the tank stands or follows a table, which
// have none.
double forcing_frequency(const CaseDefinition& definition);

}  // namespace slosh

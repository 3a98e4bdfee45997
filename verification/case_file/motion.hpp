// The tank's horizontal motion as functions of time, made from a case's definition: what each solver and
// reference is handed.
#pragma once

#include <functional>

#include "verification/case_file/case_definition.hpp"

namespace slosh {

struct SurgeMotion {
  std::function<double(double)> displacement;  // X(t) [m]
  std::function<double(double)> velocity;      // X'(t) [m/s]
  std::function<double(double)> acceleration;  // X''(t) [m/s2]
};

// Throws CaseFileError for a roll, which no solver takes yet.
SurgeMotion surge_motion(const CaseDefinition& definition);

// The forcing's angular frequency [rad/s]; zero for a table, which has none.
double forcing_frequency(const CaseDefinition& definition);

}  // namespace slosh

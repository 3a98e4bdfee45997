// How much of a recorded motion's acceleration is the noise of its positions: of a gauge, or of the
// digits with which they were written. Where positions scatter by s about a smooth motion, and
// independently, the second derivatives of the cubic spline through points a time dt apart scatter
// by 6 s / dt^2: the spline turns exp(i a n) into 6 (1 - cos a) / (2 + cos a) / dt^2 of itself, the
// mean of whose square over all a is 36 / dt^4.
#pragma once

#include <string>
#include <vector>

#include "verification/assessment/doubts/model_limit.hpp"
#include "verification/case/case_definition.hpp"

namespace slosh {

// Returns, for each motion by a table of seven points or more, the rms of the noise over that of
// the acceleration, both at the table's points, and with it which smoothing would leave a tenth.
std::vector<ModelLimit> motion_noise(const CaseDefinition& definition);

// "doubtful: the noise of motion.surge, ...", one line for each of them that is exceeded.
std::string doubtful_motion(const CaseDefinition& definition);

}  // namespace slosh

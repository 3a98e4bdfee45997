// What sets repeats of a run apart: a wave of the level at the start, far smaller than a cell, of
// which a violent flow makes another history of the same flow. The seed decides which of the first
// eight modes it is (all that 25 cells resolve well), its amplitude between half the largest and
// the largest, and its sign. A cosine of whole half waves keeps the liquid's volume
// (wavy_level.hpp).
#pragma once

#include "openfoam_cases/sloshing_tank.hpp"

namespace slosh::openfoam {

// `largest` [m] is above zero.
InitialWave start_disturbance(double largest, unsigned seed);

}  // namespace slosh::openfoam

#pragma once

#include "openfoam_cases/sloshing_tank.hpp"

namespace slosh::openfoam {

// Throws std::invalid_argument for an impossible tank. The motion is checked where it is tabulated
// (frame_motion.hpp).
void check_tank(const SloshingTank& tank);

}  // namespace slosh::openfoam

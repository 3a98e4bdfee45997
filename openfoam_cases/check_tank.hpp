// Refuses a tank that cannot be.
#pragma once

#include <string>

#include "openfoam_cases/sloshing_tank.hpp"

namespace slosh::openfoam {

// Throws std::invalid_argument that names the key, its value and what was expected.
void require(bool condition, const char* key, double value, const std::string& expected);

// Throws std::invalid_argument; the motion is checked where it is tabulated.
void check_tank(const SloshingTank& tank);

}  // namespace slosh::openfoam

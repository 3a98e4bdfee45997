// The time steps that the solver is given [s]; in violent flow it shortens them by its Courant
// number. And how often it corrects the pressure in each.
#pragma once

#include "openfoam_cases/sloshing_tank.hpp"

namespace slosh::openfoam {

double max_time_step(const SloshingTank& tank);
double first_time_step(const SloshingTank& tank);
int pressure_corrections(const SloshingTank& tank);

}  // namespace slosh::openfoam

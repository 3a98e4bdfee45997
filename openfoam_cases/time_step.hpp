// The numerical settings of the solver that depend on the tank.
#pragma once

#include "openfoam_cases/sloshing_tank.hpp"

namespace slosh::openfoam {

// The largest and the first time step [s]. In violent flow the Courant number limits the step
// further.
double max_time_step(const SloshingTank& tank);
double first_time_step(const SloshingTank& tank);

// The interval of the table of the tank's motion [s].
double motion_step(const SloshingTank& tank);

// The number of pressure corrections in each solution of the equations.
int pressure_corrections(const SloshingTank& tank);

}  // namespace slosh::openfoam

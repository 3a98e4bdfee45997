// The equations of state of compressibleInterFoam, which has them at 20 degrees Celsius and the
// standard atmosphere, where both fluids have the densities of the tank.
//
//     liquid:  rho = rho0 + p / (R T),   R T = c^2,   rho0 = rho_liquid - p_atm / c^2
//     gas:     rho = p W / (R_m T),      W = rho_gas R_m T / p_atm
//
// c is the speed of sound in water, and R_m the molar gas constant. The program also solves for the
// temperature. The fluids have a thousand times the heat capacities of water and air, so
// that the temperature stays: a gas at twice its pressure warms by less than 0.1 K. The gas is thus
// a spring of the exponent 1; air in a pocket of some centimetres, which has no time to give its
// heat away, is stiffer by up to 1.4.
#pragma once

#include <kainjow/mustache.hpp>

#include "openfoam_cases/sloshing_tank.hpp"

namespace slosh::openfoam {

// [Pa], the pressure of the gas at the start: the standard atmosphere.
inline constexpr double atmosphere = 101325;

// Sets the values of the names in the templates of the fluids' properties.
void set_compressible_fluids(const SloshingTank& tank, kainjow::mustache::data& values);

}  // namespace slosh::openfoam

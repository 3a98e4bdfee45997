// What the models take too little or too much of a wave's amplitude in each period:
// - Friction at walls: (pi / 2) delta / h, with a Stokes layer delta on the bottom of a liquid of
//   depth h (Keulegan 1959). It is half of sqrt(nu omega / 2) rho U^2 / 2 per area over
//   rho h U^2 / 2.
// - Artificial viscosity: 2 nu k^2 times the period, of the first mode with the nu of
//   solvers/particles/artificial_viscosity.hpp (Lamb, article 348; Monaghan 2005, section 8.5).
#pragma once

#include <vector>

#include "verification/assessment/doubts/model_limit.hpp"
#include "verification/case/case_definition.hpp"

namespace slosh {

// Returns, of those that apply:
//   the friction of the liquid at walls where it slips in the model, or sticks in layers thinner
//     than three particles, or than three of the cells beside the walls
//   the artificial viscosity of an SPH run that sets its own
std::vector<ModelLimit> damping_limits(const CaseDefinition& definition);

}  // namespace slosh

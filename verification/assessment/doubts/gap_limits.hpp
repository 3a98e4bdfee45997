// What the runs leave out of the front and the back wall of their tank. The laminar layers of these
// walls act on a mean velocity v exp(i omega t) over the gap b as the force per mass W v, with
//   W = i omega T / (1 - T),   T = tanh(kappa) / kappa,   kappa = (b / 2) sqrt(i omega / nu)
// (Landau & Lifshitz 1987, section 24, problem 6; docs/walls.md, narrow tanks):
// - Friction: Re W takes pi Re W / omega of a wave's amplitude in each period.
// - Added mass: the share a = Im W / omega of the liquid's inertia lowers a natural frequency by
//   a / 2. A wave without it runs ahead by the angle pi a in each period, and so differs by pi a of
//   its amplitude.
// With thin layers delta both are pi delta / b of the amplitude. One limit therefore holds for
// both, and 1 / pi of it is that on the added mass.
#pragma once

#include <vector>

#include "verification/assessment/doubts/model_limit.hpp"
#include "verification/case/case_definition.hpp"

namespace slosh {

// Returns the friction of these walls in thin layers, of a tank as broad as long, where the case
// gives no breadth; otherwise the added mass, which the runs of OpenFOAM in two dimensions leave
// out.
std::vector<ModelLimit> gap_limits(const CaseDefinition& definition);

}  // namespace slosh

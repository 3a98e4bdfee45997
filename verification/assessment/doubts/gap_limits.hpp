// What the runs leave out of the gap walls of their tank, the gap b apart
// (case/gap_friction.hpp; docs/walls.md, narrow tanks):
// - The friction r takes pi r / omega of a wave's amplitude in each period.
// - The added mass a, a share of the liquid's inertia, lowers a natural frequency by a / 2. A wave
//   without it runs ahead by the angle pi a in each period, and so differs by pi a of its
//   amplitude.
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

// A particle spacing that divides the liquid. The lattice from which an SPH run starts has whole
// numbers of particles along the tank's length (or the width of a dam) and along the depth, and is
// stretched to fit; initial_lattice.hpp of sph/ says how far.
#pragma once

#include <optional>
#include <string>

#include "verification/case/case_definition.hpp"

namespace slosh {

// Returns the spacing [m] nearest to this one, by their ratio, that divides both lengths to a
// millionth; where none within a factor of two does, the nearest that divides the first and fits
// the second. Returns nullopt if there is none either.
std::optional<double> nearest_fitting_spacing(const CaseDefinition& definition, double spacing);

// Returns what to add to the refusal of a run: "; the nearest that divides both is 0.1 m" if the
// refusal is of its spacing, which does not fit, and otherwise an empty text.
std::string spacing_hint(const std::string& refusal, const CaseDefinition& definition,
                         const RunDefinition& run);

}  // namespace slosh

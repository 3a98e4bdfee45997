// Which runs of a case belong together: those of a family differ in resolution alone.
#pragma once

#include <string>

#include "verification/case/case_definition.hpp"

namespace slosh {

// SPH by its scheme, interFoam as such, any other run by itself.
std::string family(const RunDefinition& run);

// Grows with the resolution; comparable within a family.
double resolution(const RunDefinition& run);

// [particle spacings] A start disorder up to this size only tells the repeats of a run apart; it
// changes nothing of the scheme.
inline constexpr double unseen_disorder = 1e-4;

// What a run changes of its scheme: "", "shifting", "courant_number = 0.4", ...
std::string changes_of(const SphRun& run);

// Whether an SPH run has something of its scheme changed.
bool is_changed(const RunDefinition& run);

// The family, and what the run changes of its scheme: "recommended", "recommended, courant_number =
// 0.4", "interFoam", ... Costs and biases are judged within it.
std::string work_family(const RunDefinition& run);

}  // namespace slosh

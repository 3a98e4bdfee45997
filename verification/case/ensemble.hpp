// repeats = N makes an ensemble of one [[run]]: N runs that differ only in their seed, by which
// their start is disturbed, or their inputs are drawn (drawn_inputs.hpp), or both. The first keeps
// the name and represents the ensemble in gate rows and refinements; the others are NAME_2 ...
// NAME_N. Each is planned, started and stored as any run.
#pragma once

#include <string>
#include <vector>

#include "verification/case/case_definition.hpp"

namespace slosh {

inline constexpr int most_repeats = 1000;

// Returns the members of the ensemble that an SPH or interFoam run begins, with the seeds
// start_seed, start_seed + 1, ... Of a quick run the first quick_repeats are quick.
std::vector<RunDefinition> ensemble_of(const RunDefinition& first, int repeats, int quick_repeats);

// Returns the seed of an SPH or interFoam run. Throws std::bad_variant_access for any other.
int start_seed(const RunDefinition& run);

// Returns whether the run is the second or a later member of an ensemble.
bool is_later_member(const RunDefinition& run);

// Returns the names of all members if `run` is the first of an ensemble, and its own otherwise.
std::vector<std::string> members_of(const CaseDefinition& definition, const std::string& run);

// Takes the members that are not quick out of the ensembles whose first member is.
void keep_quick_members(CaseDefinition& definition);

}  // namespace slosh

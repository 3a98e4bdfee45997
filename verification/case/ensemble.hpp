// repeats = N makes one [[run]] N runs that differ in the seed of their disturbed start alone: an
// ensemble. The first keeps the name, and stands for all of them in gate rows and refinements; the
// others are NAME_2 ... NAME_N. What runs, stores and shows them knows them as runs.
#pragma once

#include <string>
#include <vector>

#include "verification/case/case_definition.hpp"

namespace slosh {

inline constexpr int most_repeats = 1000;

// Of an SPH or interFoam run with start_disorder > 0 and `repeats` of 2 or more: its members, with
// the seeds start_seed, start_seed + 1, ...
std::vector<RunDefinition> ensemble_of(const RunDefinition& first, int repeats);

// Whether the run is the second or a later one of an ensemble, which its first stands for.
bool is_later_member(const RunDefinition& run);

// The names of all members where `run` is the first of an ensemble, else itself alone.
std::vector<std::string> members_of(const CaseDefinition& definition, const std::string& run);

}  // namespace slosh

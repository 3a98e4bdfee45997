// repeats = N makes an ensemble of one [[run]]: N runs that differ only in their seed, by which
// their start is disturbed, or their inputs are drawn, or both. The first keeps
// the name and represents the ensemble in gate rows and refinements; the others are NAME_2 ...
// NAME_N. Each is planned, started and stored as any run.
#pragma once

#include <string>
#include <vector>

#include "verification/case/case_definition.hpp"

namespace slosh {

// vary_inputs = true: each member of an ensemble solves the case with its own inputs, as each
// repeat of an experiment has its own fill depth and motion. Every declared [[input]] is drawn from
// the normal distribution whose 95 % interval is the declared one,
//   change = half_width z / 1.96,   z from the standard normal distribution.
// All members are drawn, the first too: they are one sample of independent members, which the tests
// and intervals of ensembles suppose. (A Latin hypercube would cover the intervals more evenly, but
// its members depend on one another, and more repeats would change those that were computed.) What
// is drawn depends on the member's seed and on the input alone: more repeats or another [[input]]
// change no draw. The changes are rounded to a millionth of the half width, so that they are the
// same on every machine.

// One change of each declared input, in their order.
std::vector<InputChange> drawn_inputs(const std::vector<InputUncertainty>& inputs, int seed);

// Draws the inputs of all runs that vary them, each by its start_seed.
void draw_inputs(CaseDefinition& definition);

// "fill_depth +0.00031 m, amplitude -0.012 deg"; "" where none is drawn.
std::string drawn_inputs_text(const RunDefinition& run, const MotionDefinition& motion);

inline constexpr int most_repeats = 1000;

// Returns the members of the ensemble that an SPH or interFoam run begins, with the seeds
// start_seed, start_seed + 1, ... Of a quick run the first quick_repeats are quick.
std::vector<RunDefinition> ensemble_of(const RunDefinition& first, int repeats, int quick_repeats);

// Returns whether the run's table takes the key `repeats`: it is of SPH or interFoam.
bool may_repeat(const RunDefinition& run);

// Returns the seed of an SPH or interFoam run. Throws std::bad_variant_access for any other.
int start_seed(const RunDefinition& run);

// Returns whether the run is the second or a later member of an ensemble.
bool is_later_member(const RunDefinition& run);

// Returns the names of all members if `run` is the first of an ensemble, and its own otherwise.
std::vector<std::string> members_of(const CaseDefinition& definition, const std::string& run);

// Takes the members that are not quick out of the ensembles whose first member is.
void keep_quick_members(CaseDefinition& definition);

}  // namespace slosh

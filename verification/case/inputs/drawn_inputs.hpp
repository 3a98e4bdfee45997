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
#pragma once

#include <string>
#include <vector>

#include "verification/case/case_definition.hpp"

namespace slosh {

// One change of each declared input, in their order.
std::vector<InputChange> drawn_inputs(const std::vector<InputUncertainty>& inputs, int seed);

// Draws the inputs of all runs that vary them, each by its start_seed.
void draw_inputs(CaseDefinition& definition);

// "fill_depth +0.00031 m, amplitude -0.012 deg"; "" where none is drawn.
std::string drawn_inputs_text(const RunDefinition& run, const MotionDefinition& motion);

}  // namespace slosh

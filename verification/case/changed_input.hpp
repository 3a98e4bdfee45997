// The inputs that a case may declare uncertain, a case with one of them changed, and the runs that
// show how a metric responds to the change where no theory does: a coarse run, repeated at both
// ends of the input's interval. These are planned, started and stored as any run of the case; only
// the report treats them differently.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "verification/case/case_definition.hpp"

namespace slosh {

// Returns the name in the case file: "fill_depth".
std::string input_name(Input input);

// Returns "m", "s", "kg/m3", "m2/s", "m/s2" or "deg"; of an amplitude "m" (surge) or "deg" (roll).
std::string input_unit(Input input, const MotionDefinition& motion);

// Returns the case with one input increased by `change` [the input's unit]. A change of the period
// stretches the times of a motion table, a change of the amplitude its values. A change of the
// start's phase is that of every sine of the motion; std::logic_error is thrown for a table, which
// has none. Gauges move along x, or along their wall.
CaseDefinition with_input(CaseDefinition definition, Input input, double change);

// Why no tank can be as the case with a changed input says, after the rules of the case file:
// "fill depth = 1.05 m: expected above 0 and below the tank's height, 1 m". Returns nullopt where
// it can.
std::optional<std::string> impossible(const CaseDefinition& definition);

// Returns the case that the run solves: with a changed input if the run stands at the end of an
// input's interval, with its drawn inputs if it has any, and as it is otherwise.
CaseDefinition definition_solved_by(const RunDefinition& run, const CaseDefinition& definition);

// Returns the runs RUN_INPUT_lower and RUN_INPUT_upper, in this order.
std::vector<RunDefinition> runs_at_ends(const InputUncertainty& input,
                                        const RunDefinition& repeated);

}  // namespace slosh

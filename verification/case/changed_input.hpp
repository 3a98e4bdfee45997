// A case with one of its uncertain inputs changed, and the runs that tell what a change makes of a
// metric where no theory does: a coarse run, repeated at both ends of the input's interval. What
// plans, runs and stores them knows them as runs of the case; the report knows their difference.
#pragma once

#include <vector>

#include "verification/case/case_definition.hpp"

namespace slosh {

// The case with one input greater by `change` [the input's unit]. A table's times are stretched by
// its period, its values by its amplitude; gauges move along x, or along their wall.
CaseDefinition with_input(CaseDefinition definition, Input input, double change);

// The case itself, or with the input changed at whose end the run is.
CaseDefinition definition_solved_by(const RunDefinition& run, const CaseDefinition& definition);

// RUN_INPUT_lower and RUN_INPUT_upper, in this order.
std::vector<RunDefinition> runs_at_ends(const InputUncertainty& input,
                                        const RunDefinition& repeated);

}  // namespace slosh

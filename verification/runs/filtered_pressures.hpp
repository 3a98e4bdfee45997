// What follows from the series that a run leaves: the low-pass filtered pressures
// (low_pass_filter.hpp), for each gauge of its case that names a cutoff, and what a surface gauge
// reads where no liquid stands below it.
#pragma once

#include <string>
#include <vector>

#include "verification/case/case_definition.hpp"
#include "verification/results/result_file.hpp"

namespace slosh {

// Adds "wall_pressure@B/filtered" beside "wall_pressure@B", in place of one that the result has,
// and of a record's band "wall_pressure@B/filtered/lower" and ".../upper". The filter of a quantile
// stands for the quantile of the filtered repeats, which are not published. Returns why each series
// that could not be filtered was not.
std::vector<std::string> add_filtered_pressures(const CaseDefinition& definition,
                                                RunResult& result);

// Raises the elevations and the highest surfaces of a run that solves the flow, SPH or OpenFOAM, to
// the floor below their gauges. SPH's column integral reaches a little below an empty column, and
// over a chamfer both count from the level of the tank's bottom. What a program of the user's or a
// theory leaves stays as it is: a surface below the floor is an error of its own there.
void raise_dry_gauges(const CaseDefinition& definition, const RunDefinition& run,
                      RunResult& result);

}  // namespace slosh

// The low-pass filtered series of a result's pressures (low_pass_filter.hpp), for each gauge of its
// case that names a cutoff.
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

}  // namespace slosh

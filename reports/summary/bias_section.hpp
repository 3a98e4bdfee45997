// The section on bias and scatter of a campaign's models, as NIST's FDS validation guide tells of
// them: a table and, for each kind of quantity, predicted values over the references' and their
// ratios.
#pragma once

#include <vector>

#include "reports/model/report_model.hpp"
#include "verification/assessment/predictions.hpp"

namespace slosh {

// Models with too few comparisons are named with their number, and neither drawn nor in the table.
// Without any set the section says why.
reports::Section bias_section(const std::vector<PredictionSet>& sets);

}  // namespace slosh

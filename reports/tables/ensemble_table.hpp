// What the rows on ensembles rest on: how the metric spreads over the repeats of either side,
// beside its mean and the interval that they give it (ensemble_mean.hpp).
#pragma once

#include <optional>

#include "reports/model/report_model.hpp"
#include "verification/assessment/case_assessment.hpp"

namespace slosh {

// One line for each gate row on an ensemble that was judged; none without any.
std::optional<reports::Table> ensemble_table(const CaseAssessment& assessment);

}  // namespace slosh

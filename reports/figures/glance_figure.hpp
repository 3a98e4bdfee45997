// A case at a glance: the time series of its first quantity as one of a campaign's small multiples.
#pragma once

#include <optional>
#include <string>

#include "reports/model/report_model.hpp"
#include "verification/assessment/case_assessment.hpp"

namespace slosh {

// Shows the first reference inside its range, or else any reference; the finest SPH run or external
// program; and the finest interFoam run. Of several schemes it is that of `candidate`, the run that
// decides the case, or else the first. A series of many periods is shown over the last ones of the
// comparison window. Returns nullopt where no run has the quantity.
std::optional<reports::Figure> glance_figure(const CaseAssessment& assessment,
                                             const std::string& candidate = "");

}  // namespace slosh

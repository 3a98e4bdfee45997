// What each choice of a scheme gives and costs: the SPH runs of a case side by side.
#pragma once

#include <optional>
#include <string>

#include "reports/model/report_model.hpp"
#include "verification/assessment/case_assessment.hpp"

namespace slosh {

// Of each SPH run its errors against theory or a record, its cost, and what both are of those of
// the unchanged run of the same scheme and spacing. Nothing where no SPH run of the case changes
// anything or none is compared with theory or a record.
std::optional<reports::Table> ablation_table(const CaseAssessment& assessment);

}  // namespace slosh

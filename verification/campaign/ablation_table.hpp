// What each choice of a scheme gives and costs: the SPH runs of a case side by side.
#pragma once

#include <optional>
#include <string>

#include "reports/report_model.hpp"
#include "verification/campaign/case_assessment.hpp"

namespace slosh {

// What a run changes of its scheme: "", "shifting", "courant_number = 0.4", ...
std::string changes_of(const SphRun& run);

// Of each SPH run its errors against theory or a record, its cost, and what both are of those of
// the unchanged run of the same scheme and spacing. Nothing where no SPH run of the case changes
// anything or none is compared with theory or a record.
std::optional<reports::Table> ablation_table(const CaseAssessment& assessment);

}  // namespace slosh

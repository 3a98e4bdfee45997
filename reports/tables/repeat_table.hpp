// Repeats of one run, which differ in the seed of their start alone, as a sample beside that of the
// experiment's repeats: no single impact can be told beforehand, their distribution can.
#pragma once

#include <optional>
#include <vector>

#include "reports/model/report_model.hpp"
#include "verification/assessment/case_assessment.hpp"

namespace slosh {

// The SPH runs that differ in start_seed only, in the order of the case file; two or more each.
std::vector<std::vector<const RunDefinition*>> repeated_runs(const CaseDefinition& definition);

// Of each impact's peak over such runs: mean, standard deviation, central 90 % and the area metric
// to the experiment's repeats (distribution.hpp). Nothing where the case has no [impacts] or no
// repeated runs.
std::optional<reports::Table> repeat_table(const CaseAssessment& assessment);

}  // namespace slosh

// The impacts of a case's runs beside the published ones.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reports/model/report_model.hpp"
#include "verification/assessment/case_assessment.hpp"

namespace slosh {

// The pressure at the gauge of the case's impacts: as it is, and filtered where the gauge has a
// cutoff.
std::vector<std::string> impact_pressures(const CaseDefinition& definition);

// Which of them one is: "as it is" or "filtered".
std::string pressure_word(const std::string& quantity);

// Where a peak [Pa] falls among the experiment's: "43 %" of the repeats lie below it, or, where
// their table is not supplied, "-0.3 sd" from the published mean.
std::string place_among_repeats(const CaseDefinition& definition, std::size_t impact, double peak);

// Per run and pressure: when each impact comes, its peak and the plateau behind it; the published
// ones and the record's on top. Nothing where the case has no [impacts].
std::optional<reports::Table> impact_table(const CaseAssessment& assessment);

}  // namespace slosh

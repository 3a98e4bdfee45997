// Error against cost of a case as JSON: families[] with runs[], slopes, and what the told errors
// cost.
#pragma once

#include <nlohmann/json.hpp>

#include "verification/assessment/case_assessment.hpp"

namespace slosh {

// {"value", "half_width_95"}, in the unit that the key names.
nlohmann::ordered_json estimate_json(const Estimate& value);

// What the repeats of a run took that had a core for themselves, in the order they were made.
nlohmann::ordered_json timings_json(const CaseRuns& runs, const std::string& run);

nlohmann::ordered_json work_precision_json(const CaseAssessment& assessment);

}  // namespace slosh

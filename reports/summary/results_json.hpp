// The campaign's outcome as JSON, for machines. Its schema, version 3, is
// reports/results.schema.json, which every report has beside it. Numbers in SI units, the unit in
// the key; a number that does not exist is null.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "verification/assessment/case_assessment.hpp"
#include "verification/assessment/problem_assessment.hpp"

namespace slosh {

std::string results_json(const std::string& campaign, bool quick,
                         const std::vector<CaseAssessment>& cases,
                         const std::vector<ProblemAssessment>& problems = {});

// One comparison as it stands in comparisons[].
nlohmann::ordered_json comparison_entry(const Comparison& pair);

}  // namespace slosh

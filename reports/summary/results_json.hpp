// The campaign's outcome as JSON. Its schema, version 3, is reports/results.schema.json; every
// report has a copy of it. Numbers are in SI units, with the unit in the key; NaN is written as
// null.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "verification/assessment/case_assessment.hpp"
#include "verification/assessment/predictions.hpp"
#include "verification/assessment/problem_assessment.hpp"

namespace slosh {

// With the claims of the paper, as campaign files name it, unless it is "".
std::string results_json(const std::string& campaign, bool quick,
                         const std::vector<CaseAssessment>& cases,
                         const std::vector<ProblemAssessment>& problems = {},
                         const std::string& paper = "");

// The same document with another exit status.
std::string with_exit_status(int status, const std::string& results_json);

// Its parts, each as in results.json.

// {"value", "half_width_95"}, in the unit that the key names.
nlohmann::ordered_json estimate_json(const Estimate& value);

// Error against cost: work_precision[] of a case.
nlohmann::ordered_json work_precision_json(const CaseAssessment& assessment);

// One entry of model_bias[].
nlohmann::ordered_json bias_json(const PredictionSet& set);

// One entry of comparisons[].
nlohmann::ordered_json comparison_entry(const Comparison& pair);

}  // namespace slosh

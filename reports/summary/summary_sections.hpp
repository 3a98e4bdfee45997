// The sections of a campaign's first page: its verdicts at a glance, the gate rows worst first,
// bias and scatter of its models.
#pragma once

#include <string>
#include <vector>

#include "reports/model/report_model.hpp"
#include "verification/assessment/case_assessment.hpp"
#include "verification/assessment/problem_assessment.hpp"

namespace slosh {

// `how_to_repeat` is shown as it is.
std::vector<reports::Section> summary_sections(const std::vector<CaseAssessment>& cases,
                                               const std::vector<ProblemAssessment>& problems,
                                               const std::string& how_to_repeat);

}  // namespace slosh

// Zhao et al. 2021 beside this harness: the claims of the paper and its errata, with the figures
// computed here.
#pragma once

#include <vector>

#include "reports/model/report_model.hpp"
#include "verification/assessment/case_assessment.hpp"

namespace slosh {

reports::Section zhao2021_section(const std::vector<CaseAssessment>& cases);

}  // namespace slosh

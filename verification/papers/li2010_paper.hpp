// Li et al. 2010 beside this harness: the paper's claims, its printed numbers and its errata, with
// the figures computed here.
#pragma once

#include <vector>

#include "reports/model/report_model.hpp"
#include "verification/assessment/case_assessment.hpp"

namespace slosh {

reports::Section li2010_section(const std::vector<CaseAssessment>& cases);

}  // namespace slosh

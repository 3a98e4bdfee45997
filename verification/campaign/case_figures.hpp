// The figures of one case's section of a report.
#pragma once

#include <vector>

#include "reports/report_model.hpp"
#include "verification/campaign/case_assessment.hpp"

namespace slosh {

// Time history of the case's first quantity (as figures 1 to 3 of Li et al. 2010), residuals with
// the tolerance band, spectra with the predicted frequencies, error against run time. A figure for
// which no run stands is left out.
std::vector<reports::Figure> case_figures(const CaseAssessment& assessment);

}  // namespace slosh

// The figures of one case's section of a report.
#pragma once

#include <vector>

#include "reports/model/report_model.hpp"
#include "verification/assessment/case_assessment.hpp"

namespace slosh {

// The tank's roll; histories of all that was compared (as figures 1 to 3, 5 and 6 of Li et al.
// 2010); residuals with the tolerance band; amplitude and lag over time and as phasors; spectra
// with the predicted frequencies (figure 7 there); studies of time step and spacing (figures 10 and
// 11 of Zhao et al. 2021); convergence; energy budgets; error against run time and against memory,
// the last. A figure for which no run stands is left out.
std::vector<reports::Figure> case_figures(const CaseAssessment& assessment);

// The histories alone, of runs that nobody has judged: references beyond their range are marked and
// pressures filtered as a report does it.
std::vector<reports::Figure> case_histories(const CaseDefinition& definition, CaseRuns runs);

// Pressure and velocity at the case's snapshot times: a row a moment, a column a solver or scheme;
// last the case's animation, of the two first runs that left all of its moments.
std::vector<reports::FieldFigure> case_fields(const CaseAssessment& assessment);

}  // namespace slosh

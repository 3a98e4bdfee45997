// A problem's section of a report, and its rows of the gate's table.
#pragma once

#include <vector>

#include "reports/report_model.hpp"
#include "verification/campaign/problem_assessment.hpp"

namespace slosh {

// The statement, the source, the exact solution, errors and observed orders over the resolutions,
// the errors drawn, the problem's own figures, and the limits with their reasons.
reports::Section problem_section(const ProblemAssessment& assessment);

// To the table that gate_table() of case_tables.hpp makes.
void add_gate_rows(const std::vector<ProblemAssessment>& problems, reports::Table& gate);

}  // namespace slosh

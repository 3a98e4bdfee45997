// How much faster than interFoam each method of a case is at the same error.
#pragma once

#include <string>
#include <vector>

#include "verification/assessment/case_assessment.hpp"
#include "verification/evidence/run_cost.hpp"

namespace slosh {

// The errors for which tables and results.json state the cost: 10, 5, 2 and 1 %.
const std::vector<double>& stated_errors();

// The families for which tables state costs: those that change nothing of their scheme, and those
// of two or more resolutions.
std::vector<WorkFamily> stated_families(const CaseAssessment& assessment);

// How many times the speed of interFoam a method has where both have the same error: the smallest
// that both reach with runs of theirs, which is that of the less accurate one's finest run.
struct EqualErrorSpeed {
  std::string family;
  double error;
  double value;      // core-seconds of interFoam over the family's
  double spread;     // half width of ln value: of costs, and of errors in another window
  bool is_repeated;  // the costs behind it were measured twice or more, alone on a core
};

// One for each stated family of SPH and of other codes; none where no such error is there.
std::vector<EqualErrorSpeed> equal_error_speeds(const CaseAssessment& assessment);

// Returns "SPH: 7.1 times the speed of interFoam at equal error (9.4 %), 5.0 to 10".
std::string speed_text(const EqualErrorSpeed& speed);

}  // namespace slosh

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

struct SpeedUp {
  double error;          // that of an interFoam run
  std::string mesh_run;  // that run
  double value;          // its core-seconds over the family's at that error; NaN where not reached
  double spread;         // half width of ln value, from all known intervals
  Reach reach;           // by_cheapest: the value is a lower bound
};

// Compares a family with each mesh of interFoam's Pareto front. Returns none where the case has no
// interFoam run, and for interFoam itself.
std::vector<SpeedUp> speed_ups(const WorkFamily& family, const std::vector<WorkFamily>& families);

}  // namespace slosh

// What each method needs for a given error, in run time and memory, and how much faster than
// interFoam it is at the same error.
#pragma once

#include <vector>

#include "reports/model/report_model.hpp"
#include "verification/assessment/case_assessment.hpp"
#include "verification/assessment/work_points.hpp"

namespace slosh {

// The errors whose cost is told: 10, 5, 2 and 1 %.
const std::vector<double>& told_errors();

// The families that change nothing of their scheme, and those of two or more resolutions.
std::vector<WorkFamily> told_families(const CaseAssessment& assessment);

struct SpeedUp {
  double error;          // that of an interFoam run
  std::string mesh_run;  // that run
  double value;          // its core-seconds over what the error costs the family; NaN where none
  double spread;         // half width of ln value, of all bars that are known
  Reach reach;           // by_cheapest: at least the value
};

// Of a family against each mesh of interFoam's Pareto front; none where the case has none, and none
// of interFoam itself.
std::vector<SpeedUp> speed_ups(const WorkFamily& family, const std::vector<WorkFamily>& families);

// Cost to reach an error in core-seconds and in memory, and the speed against interFoam; those for
// which nothing stands are left out.
std::vector<reports::Table> work_precision_tables(const CaseAssessment& assessment);

}  // namespace slosh

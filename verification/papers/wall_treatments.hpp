// Wall treatments side by side: the runs of a campaign's cases with the tag "walls" that are named
// by how they make the walls.
#pragma once

#include <optional>
#include <vector>

#include "reports/model/report_model.hpp"
#include "verification/assessment/case_assessment.hpp"

namespace slosh {

// As runs are named: the walls of li2010, of zhao2021 in its two ways, and of recommended.
inline constexpr const char* wall_treatments[] = {"repulsive_mirror", "dynamic_moving",
                                                  "dynamic_fixed", "mirror"};

// A table of gap, pressure noise (pressure_noise.hpp), volume drift, wall crossings and cost, and a
// figure of noise and cost. A treatment holds the liquid where no particle crossed a wall. Nothing
// where no case with the tag has such a run.
std::optional<reports::Section> wall_treatment_section(const std::vector<CaseAssessment>& cases);

}  // namespace slosh

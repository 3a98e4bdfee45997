// The sections of a report that compare this harness with the papers.
#pragma once

#include <optional>
#include <vector>

#include "reports/model/report_model.hpp"
#include "verification/assessment/case_assessment.hpp"
#include "verification/papers/paper_figures.hpp"

namespace slosh {

// The claims of Li et al. 2010, its printed numbers and its errata, with the numbers computed here.
// Rows link to the panels that the paper's figures were redrawn in.
reports::Section li2010_section(const std::vector<CaseAssessment>& cases,
                                const RedrawnFigures& redrawn);

// The claims of Zhao et al. 2021 and its errata, likewise.
reports::Section zhao2021_section(const std::vector<CaseAssessment>& cases,
                                  const RedrawnFigures& redrawn);

// The wall treatments, as runs are named: the walls of li2010, of zhao2021 in its two ways, and of
// recommended.
inline constexpr const char* wall_treatments[] = {"repulsive_mirror", "dynamic_moving",
                                                  "dynamic_fixed", "mirror"};

// Compares the wall treatments over the cases with the tag "walls": a table of gap, pressure noise
// (pressure_noise.hpp), volume drift, wall crossings and cost, and a figure of noise and cost. A
// treatment holds the liquid where no particle crossed a wall. Returns nullopt where no case with
// the tag has such a run.
std::optional<reports::Section> wall_treatment_section(const std::vector<CaseAssessment>& cases);

}  // namespace slosh

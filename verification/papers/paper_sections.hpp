// The sections of a report that compare this harness with the papers.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reports/model/report_model.hpp"
#include "verification/assessment/case_assessment.hpp"
#include "verification/papers/claims.hpp"
#include "verification/papers/paper.hpp"

namespace slosh {

// What a report has of one of the paper's figures.
struct RedrawnFigure {
  std::string number;
  std::vector<std::string> anchors = {};  // of the panels, in the report
  std::vector<std::string> missing = {};  // why one or more panels are left out
};
using RedrawnFigures = std::vector<RedrawnFigure>;

// "figure 5", "figures 2 and 3".
std::string figure_name(const std::string& number);

// A row on what a paper says, and the figures that it speaks of.
struct PaperRow {
  std::vector<std::string> cells;
  std::vector<std::string> figures = {};
};

// Returns the table with these rows and one more column, which names the figures of each row and
// links to the panel of the first one that has any. `head` has no rows.
reports::Table with_figures(reports::Table head, const std::vector<PaperRow>& rows,
                            const RedrawnFigures& redrawn);

// A row for each claim.
reports::Table claims_table(const std::string& id, const std::vector<DecidedClaim>& claims,
                            const RedrawnFigures& redrawn);

// The numbers that Li et al. 2010 print beside ours; the spectra of every run of a solver that two
// cases share, of an ensemble the means over its members, beside the printed ones.
reports::Table printed_numbers_table(const std::vector<CaseAssessment>& cases,
                                     const RedrawnFigures& redrawn);
reports::Table surface_spectrum_table(const CaseAssessment& smaller, const CaseAssessment& larger,
                                      const RedrawnFigures& redrawn);

// The paper's claims, errata, deviations and figures, and what it prints. Rows link to the panels
// that its figures were redrawn in; `redrawn` has one entry for each, in the same order.
reports::Section paper_section(const Paper& paper, const std::vector<CaseAssessment>& cases,
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

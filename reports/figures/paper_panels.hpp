// The figures of a paper, redrawn from the runs of a campaign.
#pragma once

#include <vector>

#include "reports/model/report_model.hpp"
#include "verification/assessment/case_assessment.hpp"
#include "verification/papers/paper_sections.hpp"

namespace slosh {

struct PaperPanels {
  std::vector<reports::Figure> figures;  // in the paper's order
  RedrawnFigures redrawn;                // one for each of the paper's figures
};

// A panel shows the case's first theory, all published records, the paper's schemes at the paper's
// spacing or else at their finest, `recommended` and interFoam, as far as they have the quantity.
// The panels of one figure that show the same quantity have the same axes. A panel without any
// simulation is left out, and `redrawn` says so. Figures of fields are those that the sections
// `written` have.
PaperPanels paper_panels(const Paper& paper, const std::vector<CaseAssessment>& cases,
                         const std::vector<reports::Section>& written);

}  // namespace slosh

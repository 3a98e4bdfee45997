#include "reports/figures/case_figures.hpp"

#include "reports/figures/figure_panels.hpp"
#include "verification/assessment/validity_envelope.hpp"
#include "verification/evidence/case_runs.hpp"

namespace slosh {

std::vector<reports::Figure> case_figures(const CaseAssessment& assessment) {
  std::vector<reports::Figure> figures;
  for (auto make : {motion_figures, main_history, residual_figures, sliding_figures, phasor_figures,
                    other_histories, spectrum_figures, study_figures, convergence_figures,
                    energy_figures, cost_figures}) {
    for (const reports::Figure& figure : make(assessment))
      for (reports::Figure& panel : in_panels(figure)) figures.push_back(std::move(panel));
  }
  return figures;
}

std::vector<reports::Figure> case_histories(const CaseDefinition& definition, CaseRuns runs) {
  mark_out_of_range(definition, runs);
  add_filtered_pressures(definition, runs);
  const CaseAssessment assessment{definition, std::move(runs), {}, {}, {}};
  std::vector<reports::Figure> figures;
  for (auto make : {main_history, other_histories})
    for (const reports::Figure& figure : make(assessment))
      for (reports::Figure& panel : in_panels(figure)) figures.push_back(std::move(panel));
  return figures;
}

}  // namespace slosh

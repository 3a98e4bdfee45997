#include "reports/figures/case_figures.hpp"

#include <iterator>

#include "verification/assessment/validity_envelope.hpp"
#include "verification/evidence/case_runs.hpp"

namespace slosh {

std::vector<reports::Figure> case_figures(const CaseAssessment& assessment) {
  std::vector<reports::Figure> figures;
  for (auto make : {motion_figures, main_history, residual_figures, sliding_figures, phasor_figures,
                    other_histories, spectrum_figures, study_figures, convergence_figures,
                    energy_figures, cost_figures}) {
    std::vector<reports::Figure> made = make(assessment);
    figures.insert(figures.end(), std::make_move_iterator(made.begin()),
                   std::make_move_iterator(made.end()));
  }
  return figures;
}

std::vector<reports::Figure> case_histories(const CaseDefinition& definition, CaseRuns runs) {
  mark_out_of_range(definition, runs);
  add_filtered_pressures(definition, runs);
  const CaseAssessment assessment{definition, std::move(runs), {}, {}, {}};
  std::vector<reports::Figure> figures = main_history(assessment);
  for (reports::Figure& one : other_histories(assessment)) figures.push_back(std::move(one));
  return figures;
}

}  // namespace slosh

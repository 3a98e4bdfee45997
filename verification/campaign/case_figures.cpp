#include "verification/campaign/case_figures.hpp"

#include <iterator>

#include "verification/campaign/figure_kinds.hpp"

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

}  // namespace slosh

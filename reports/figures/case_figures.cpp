#include "reports/figures/case_figures.hpp"

#include <algorithm>
#include <initializer_list>
#include <iterator>
#include <utility>

#include "reports/figures/figure_panels.hpp"
#include "verification/assessment/validity_envelope.hpp"
#include "verification/evidence/case_runs.hpp"

namespace slosh {

namespace {

using FigureKind = std::vector<reports::Figure> (*)(const CaseAssessment&);

std::vector<reports::Figure> figures_of(const CaseAssessment& assessment,
                                        std::initializer_list<FigureKind> kinds) {
  std::vector<reports::Figure> figures;
  for (const FigureKind make : kinds)
    for (const reports::Figure& figure : make(assessment))
      for (reports::Figure& panel : in_panels(figure)) figures.push_back(std::move(panel));
  return figures;
}

}  // namespace

std::vector<reports::Figure> case_figures(const CaseAssessment& assessment) {
  return figures_of(assessment, {main_histories, impact_figures, residual_figures, sliding_figures,
                                 phasor_figures, convergence_figures, cost_figures});
}

std::vector<reports::Figure> appendix_figures(const CaseAssessment& assessment) {
  std::vector<reports::Figure> figures =
      figures_of(assessment, {other_histories, spectrum_figures, study_figures, energy_figures});
  std::ranges::move(motion_figures(assessment.definition), std::back_inserter(figures));
  return figures;
}

std::vector<reports::Figure> case_histories(const CaseDefinition& definition, CaseRuns runs) {
  mark_out_of_range(definition, runs);
  complete_results(definition, runs);
  const CaseAssessment assessment{definition, std::move(runs), {}, {}, {}};
  std::vector<reports::Figure> figures;
  for (auto make : {main_histories, other_histories})
    for (const reports::Figure& figure : make(assessment))
      for (reports::Figure& panel : in_panels(figure)) figures.push_back(std::move(panel));
  return figures;
}

}  // namespace slosh

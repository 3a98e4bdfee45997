#include "reports/figures/case_figures.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <initializer_list>
#include <iterator>
#include <numbers>
#include <utility>

#include "reports/drawing/figure_layout.hpp"
#include "reports/figures/figure_runs.hpp"
#include "reports/wording/case_text.hpp"
#include "reports/wording/shown_quantity.hpp"
#include "verification/assessment/validity_envelope.hpp"
#include "verification/case/quantities.hpp"
#include "verification/case/solver_kinds.hpp"

namespace slosh {
namespace {

using reports::Curve;
using reports::Figure;

using FigureKind = std::vector<Figure> (*)(const CaseAssessment&);

std::vector<Figure> figures_of(const CaseAssessment& assessment,
                               std::initializer_list<FigureKind> kinds) {
  std::vector<Figure> figures;
  for (const FigureKind make : kinds)
    for (const Figure& figure : make(assessment))
      std::ranges::move(in_panels(figure), std::back_inserter(figures));
  return figures;
}

// Whether the curve stands in each panel: references and guides, beside the runs that have a look.
bool is_shared(const Curve& curve, bool runs_have_looks) {
  return runs_have_looks && (!curve.look || curve.look->is_reference);
}

constexpr double most_periods = 12;  // more are no lines any more in a small figure

// An earlier run of this harness is no truth to show a case against.
bool is_earlier_run(const RunDefinition& run) {
  const auto* record = std::get_if<RecordRun>(&run.solver);
  return record && record->earlier_run;
}

bool is_mesh(const RunDefinition& run) { return std::holds_alternative<InterFoamRun>(run.solver); }

// The part of the time axis that is shown.
std::pair<double, double> shown_times(const CaseDefinition& definition) {
  const std::vector<ToneRequest> modes = fitted_modes(definition);
  if (modes.empty()) return {0, definition.duration};
  const double shown = most_periods * 2 * std::numbers::pi / modes.front().angular_frequency;
  if (definition.duration <= shown) return {0, definition.duration};
  const double begin = std::max(0.0, definition.window_end - shown);
  return {begin, begin + shown};
}

std::string legend_text(const RunDefinition& run) {
  if (!is_simulation(run)) return "reference";
  if (is_mesh(run)) return family(run) + " (VOF)";
  return std::holds_alternative<SphRun>(run.solver) ? "SPH " + family(run) : run.name;
}

// The runs that are shown, the reference first.
std::vector<std::string> shown_runs(const CaseAssessment& assessment, const std::string& quantity,
                                    const std::string& candidate) {
  const CaseDefinition& definition = assessment.definition;
  std::string reference, particles, mesh;
  for (const std::string& name : finest_runs(assessment, quantity)) {
    const RunDefinition& run = run_named(definition, name);
    if (is_earlier_run(run)) continue;
    const bool in_range = is_in_range(assessment, name);
    if (!is_simulation(run)) {
      if (reference.empty() || (in_range && !is_in_range(assessment, reference))) reference = name;
    } else if (is_mesh(run)) {
      if (mesh.empty() || family(run) == "interFoam") mesh = name;
    } else if (particles.empty() ||
               (!candidate.empty() && family(run) == family(run_named(definition, candidate)))) {
      particles = name;
    }
  }
  std::vector<std::string> shown{reference, particles, mesh};
  std::erase(shown, "");
  return shown;
}

}  // namespace

std::vector<Figure> case_figures(const CaseAssessment& assessment) {
  return figures_of(assessment, {main_histories, impact_figures, residual_figures, sliding_figures,
                                 phasor_figures, convergence_figures, cost_figures});
}

std::vector<Figure> appendix_figures(const CaseAssessment& assessment) {
  std::vector<Figure> figures =
      figures_of(assessment, {other_histories, spectrum_figures, study_figures, energy_figures});
  std::ranges::move(motion_figures(assessment.definition), std::back_inserter(figures));
  return figures;
}

std::vector<Figure> case_histories(const CaseDefinition& definition, CaseRuns runs) {
  mark_out_of_range(definition, runs);
  complete_results(definition, runs);
  return figures_of({definition, std::move(runs), {}, {}, {}}, {main_histories, other_histories});
}

std::optional<Figure> glance_figure(const CaseAssessment& assessment,
                                    const std::string& candidate) {
  const CaseDefinition& definition = assessment.definition;
  // The pressure of the impacts where the case has any, else the first quantity that is compared.
  std::string quantity = compared_quantities(definition).front();
  if (definition.impacts)
    if (const std::string smoothest = impact_pressures(definition).back();
        !finest_runs(assessment, smoothest).empty())
      quantity = smoothest;
  const std::vector<std::string> runs = shown_runs(assessment, quantity, candidate);
  if (runs.empty()) return std::nullopt;
  const ShownQuantity shown = shown_quantity(definition, quantity);
  Figure figure = histories(assessment, quantity, runs, axes_with_units(definition, quantity));
  std::vector<std::string> names;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    names.push_back(figure.curves[i].label);
    figure.curves[i].label = legend_text(run_named(definition, runs[i]));
  }
  figure.id = case_id(definition.name) + "-glance";
  figure.title = definition.title + ": " + shown.title;
  figure.caption = fmt::format("{} of {}", shown.word, fmt::join(names, ", "));
  figure.x_range = shown_times(definition);
  figure.is_small = true;
  return figure;
}

std::vector<Figure> in_panels(const Figure& figure) {
  if (figure.curves.size() <= most_curves) return {figure};
  const bool looks =
      std::any_of(figure.curves.begin(), figure.curves.end(),
                  [](const Curve& curve) { return curve.look && !curve.look->is_reference; });
  const auto shared = static_cast<std::size_t>(
      std::count_if(figure.curves.begin(), figure.curves.end(),
                    [&](const Curve& curve) { return is_shared(curve, looks); }));
  const std::size_t of_runs = figure.curves.size() - shared,
                    room = most_curves - std::min(shared, most_curves - 1),
                    count = (of_runs + room - 1) / room;
  const auto [horizontal, vertical] = reports::plot_ranges(figure);
  std::vector<Figure> panels;
  for (std::size_t panel = 0; panel < count; ++panel) {
    Figure part = figure;
    if (panel > 0) part.id += fmt::format("-{}", panel + 1);
    part.title += fmt::format(" ({} of {})", panel + 1, count);
    part.x_range = {horizontal.lower, horizontal.upper};
    part.y_range = {vertical.lower, vertical.upper};
    std::size_t number = 0;  // among the runs
    std::erase_if(part.curves, [&](const Curve& curve) {
      return !is_shared(curve, looks) && number++ * count / of_runs != panel;
    });
    panels.push_back(std::move(part));
  }
  return panels;
}

}  // namespace slosh

#include "reports/figures/glance_figure.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numbers>
#include <vector>

#include "reports/figures/figure_runs.hpp"
#include "reports/wording/report_places.hpp"
#include "reports/wording/shown_quantity.hpp"
#include "verification/case/quantities.hpp"
#include "verification/case/solver_kinds.hpp"
#include "verification/evidence/case_evidence.hpp"

namespace slosh {
namespace {

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
  return is_mesh(run) ? family(run) + " (VOF)" : "SPH " + family(run);
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

// The pressure of the impacts where the case has any, else the first quantity that is compared.
std::string glance_quantity(const CaseAssessment& assessment) {
  const CaseDefinition& definition = assessment.definition;
  if (definition.impacts) {
    const std::string smoothest = impact_pressures(definition).back();
    if (!finest_runs(assessment, smoothest).empty()) return smoothest;
  }
  return compared_quantities(definition).front();
}

}  // namespace

std::optional<reports::Figure> glance_figure(const CaseAssessment& assessment,
                                             const std::string& candidate) {
  const CaseDefinition& definition = assessment.definition;
  const std::string quantity = glance_quantity(assessment);
  const std::vector<std::string> runs = shown_runs(assessment, quantity, candidate);
  if (runs.empty()) return std::nullopt;
  const ShownQuantity shown = shown_quantity(definition, quantity);
  reports::Figure figure;
  figure.id = case_id(definition.name) + "-glance";
  figure.title = definition.title + ": " + shown.title;
  std::vector<std::string> names;
  for (const std::string& run : runs) names.push_back(run_label(assessment, run));
  figure.caption = fmt::format("{} of {}", shown.word, fmt::join(names, ", "));
  const HistoryAxes axes = axes_with_units(definition, quantity);
  figure.x_label = axes.x_label;
  figure.y_label = axes.y_label;
  figure.x_range = shown_times(definition);
  figure.is_small = true;
  for (const std::string& run : runs) {
    figure.curves.push_back(history_curve(assessment, run, quantity, axes.scales));
    figure.curves.back().label = legend_text(run_named(definition, run));
  }
  return figure;
}

}  // namespace slosh

// How far the candidates are from their references: residuals over time, and what the error costs.
#include <fmt/format.h>

#include <cmath>
#include <map>
#include <set>

#include "verification/campaign/choice_table.hpp"
#include "verification/campaign/figure_kinds.hpp"
#include "verification/campaign/figure_runs.hpp"
#include "verification/campaign/shown_quantity.hpp"
#include "verification/case_file/quantities.hpp"
#include "verification/metrics/sample_moments.hpp"

namespace slosh {
namespace {

using reports::Curve;
using reports::Figure;

// The limit of the case's normalised_rms row in the quantity's own unit: rms error allowed; zero
// where no row gives one.
double tolerated_residual(const CaseAssessment& assessment, const Comparison& comparison) {
  for (const GateRow& row : assessment.definition.gate)
    if (row.metric == Metric::normalised_rms && row.limit &&
        row.candidate == comparison.candidate && row.reference == comparison.reference &&
        row.quantity == comparison.quantity)
      return *row.limit * rms(comparison.residual.value) / comparison.normalised_rms.value;
  return 0;
}

// More changes than the figures have colours do not make a legend that one can read.
constexpr std::size_t most_changes_named = 6;

std::size_t count_changes(const CaseAssessment& assessment) {
  std::set<std::string> changes;
  for (const Comparison* judging : judging_comparisons(assessment)) {
    const RunDefinition& run = run_named(assessment.definition, judging->candidate);
    if (is_changed(run)) changes.insert(family(run) + changes_of(std::get<SphRun>(run.solver)));
  }
  return changes.size();
}

// Under which label a run is a point: an unchanged one with its family, a changed one with what it
// changes, or with all that change anything of its scheme.
std::string cost_label(const RunDefinition& run, bool name_changes) {
  if (!is_changed(run)) return family(run);
  return family(run) + ", " +
         (name_changes ? changes_of(std::get<SphRun>(run.solver)) : "one choice changed");
}

}  // namespace

std::vector<Figure> residual_figures(const CaseAssessment& assessment) {
  const CaseDefinition& definition = assessment.definition;
  const std::string quantity = compared_quantities(definition).front();
  const ShownQuantity shown = shown_quantity(definition, quantity);
  Figure figure;
  figure.id = definition.name + "-residual";
  figure.title = "Residual against the reference";
  figure.caption = fmt::format(
      "The {}: candidate minus its reference over the comparison window, for the finest run of "
      "each scheme and solver. A band is the rms residual that the gate tolerates.",
      shown.word);
  figure.x_label = "time [s]";
  figure.y_label = fmt::format("residual [{}]", shown.unit);
  figure.x_range = {0, definition.duration};
  figure.spans = outside_window(definition);
  for (const Comparison* judging : shown_comparisons(assessment)) {
    Curve curve{judging->candidate + " - " + judging->reference,
                judging->residual.time,
                judging->residual.value,
                {},
                {}};
    for (double& value : curve.y) value *= shown.scale;
    figure.curves.push_back(std::move(curve));
    if (const double band = shown.scale * tolerated_residual(assessment, *judging); band > 0)
      figure.bands.push_back({"tolerance, " + judging->candidate, -band, band});
  }
  if (figure.curves.empty()) return {};
  return {figure};
}

// Each family a curve, each change of one points of its own.
std::vector<Figure> cost_figures(const CaseAssessment& assessment) {
  const CaseDefinition& definition = assessment.definition;
  Figure figure;
  figure.id = definition.name + "-cost";
  figure.title = "Error against run time";
  figure.caption =
      "Normalised rms error over the comparison window against the processor time of the run (user "
      "and system, all "
      "processes), other runs beside it.";
  figure.x_label = "processor time [s]";
  figure.y_label = "normalised rms error [1]";
  figure.log_x = figure.log_y = true;
  const bool name_changes = count_changes(assessment) <= most_changes_named;
  std::map<std::string, std::multimap<double, std::pair<double, double>>> points;
  std::map<std::string, Curve::Style> styles;
  std::vector<std::string> labels;
  for (const Comparison* judging : judging_comparisons(assessment)) {
    const Comparison& comparison = *judging;
    const RunDefinition& run = run_named(definition, comparison.candidate);
    const RunCost& cost = assessment.runs.results.at(run.name).cost;
    const std::string name = cost_label(run, name_changes) + " against " + comparison.reference;
    if (!points.contains(name)) labels.push_back(name);
    points[name].insert(
        {resolution(run), {cost.user_time + cost.system_time, comparison.normalised_rms.value}});
    styles[name] = is_changed(run) ? Curve::Style::points : Curve::Style::line_points;
  }
  for (const std::string& name : labels) {
    Curve curve{name, {}, {}, {}, styles[name]};
    for (const auto& [fineness, point] : points[name]) {
      curve.x.push_back(point.first);
      curve.y.push_back(point.second);
    }
    figure.curves.push_back(std::move(curve));
  }
  if (figure.curves.empty()) return {};
  return {figure};
}

}  // namespace slosh

// Time histories: the references and the finest run of each scheme and solver.
#include <fmt/format.h>

#include <numbers>

#include "reports/figures/figure_kinds.hpp"
#include "reports/figures/figure_runs.hpp"
#include "reports/figures/shown_quantity.hpp"
#include "verification/case/motion.hpp"
#include "verification/case/quantities.hpp"
#include "verification/evidence/history_uncertainty.hpp"

namespace slosh {
namespace {

using reports::Figure;

// With ribbons; whether there is one but a record's.
bool add_curves(const CaseAssessment& assessment, const std::string& quantity,
                const AxisScales& scales, Figure& figure) {
  bool numerical = false;
  figure.curves.clear();
  for (const std::string& run : finest_runs(assessment, quantity)) {
    figure.curves.push_back(history_curve(assessment, run, quantity, scales));
    std::vector<double> widths =
        numerical_half_widths(assessment.definition, assessment.runs, run, quantity);
    if (widths.empty()) continue;
    for (double& width : widths) width *= scales.value;
    set_uncertainty(figure.curves.back(), widths);
    numerical = true;
  }
  return numerical;
}

Figure history(const CaseAssessment& assessment, const std::string& quantity) {
  const CaseDefinition& definition = assessment.definition;
  const ShownQuantity shown = shown_quantity(definition, quantity);
  const std::vector<std::string> runs = finest_runs(assessment, quantity);
  Figure figure;
  figure.id = definition.name + "-" + id_of(quantity);
  figure.title = shown.title;
  figure.caption = "Time history: the references and the finest run of each scheme and solver. " +
                   measured_how(shown, definition, runs) + who_is_who(definition, runs) + " " +
                   definition.source + ".";
  figure.x_label = "time [s]";
  figure.y_label = fmt::format("{} [{}]", shown.word, shown.unit);
  figure.x_range = {0, definition.duration};
  figure.spans = outside_window(definition);
  if (add_curves(assessment, quantity, {.value = shown.scale}, figure))
    figure.caption +=
        " Ribbons about solvers: 95 % numerical uncertainty, from coarser runs (Celik et al. 2008, "
        "one order for the whole history; narrow where histories cross).";
  return figure;
}

// Without dimensions where the motion has a period.
Figure highest_surface(const CaseAssessment& assessment, const std::string& quantity) {
  Figure figure = history(assessment, quantity);
  const CaseDefinition& definition = assessment.definition;
  const double frequency = forcing_frequency(definition) / (2 * std::numbers::pi);
  if (!(frequency > 0)) return figure;
  figure.caption =
      fmt::format("h = {:.4g} m, T = {:.4g} s. ", definition.liquid.fill_depth, 1 / frequency) +
      figure.caption;
  figure.x_label = "time over the forcing period, t/T [1]";
  figure.y_label = "highest surface over the still depth, η/h [1]";
  figure.x_range.second *= frequency;
  figure.spans = outside_window(definition, frequency);
  add_curves(assessment, quantity, {.time = frequency, .value = 1 / definition.liquid.fill_depth},
             figure);
  return figure;
}

}  // namespace

std::vector<Figure> main_history(const CaseAssessment& assessment) {
  const CaseDefinition& definition = assessment.definition;
  Figure figure = history(assessment, compared_quantities(definition).front());
  figure.id = definition.name + "-history";
  if (figure.curves.empty()) return {};
  return {figure};
}

std::vector<Figure> other_histories(const CaseAssessment& assessment) {
  std::vector<Figure> figures;
  std::vector<std::string> quantities = compared_quantities(assessment.definition);
  quantities.erase(quantities.begin());
  for (const std::string& quantity : quantities) {
    Figure figure = quantity.starts_with("highest_surface@") ? highest_surface(assessment, quantity)
                                                             : history(assessment, quantity);
    if (!figure.curves.empty()) figures.push_back(std::move(figure));
  }
  return figures;
}

}  // namespace slosh

// How far the candidates are from their references: residuals over time.
#include <fmt/format.h>

#include <algorithm>

#include "reports/figures/figure_kinds.hpp"
#include "reports/figures/figure_runs.hpp"
#include "reports/figures/shown_quantity.hpp"
#include "verification/case/quantities.hpp"
#include "verification/series/sample_moments.hpp"

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

}  // namespace slosh

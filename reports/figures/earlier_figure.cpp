#include "reports/figures/earlier_figure.hpp"

#include <fmt/format.h>

#include "reports/figures/figure_runs.hpp"
#include "reports/figures/run_looks.hpp"
#include "reports/wording/report_places.hpp"
#include "reports/wording/shown_quantity.hpp"
#include "verification/evidence/case_runs.hpp"

namespace slosh {
namespace {

using reports::Curve;

Curve earlier_curve(const TimeSeries& series, const std::string& label, double scale) {
  Curve curve{label, series.time, series.value, {}, Curve::Style::dashed};
  for (double& value : curve.y) value *= scale;
  curve.look = guide_look(0);
  return curve;
}

}  // namespace

reports::Figure earlier_figure(const CaseAssessment& assessment, const GateRow& row,
                               const EarlierResult& earlier) {
  const CaseDefinition& definition = assessment.definition;
  const ShownQuantity shown = shown_quantity(definition, row.quantity);
  const HistoryAxes axes = axes_with_units(definition, row.quantity);
  reports::Figure figure;
  figure.id = fmt::format("{}-earlier-{}-{}", case_id(definition.name), name_id(row.candidate),
                          id_of(row.quantity));
  figure.title = fmt::format("{}: {} now and on {}", shown.title, row.candidate, earlier.date);
  figure.caption = fmt::format(
      "The row \"{}\" does not hold now. With the result of {} it {}. The case and the settings of "
      "the run are the same; its program has changed.",
      row_name(row), earlier.date, earlier.row_held ? "held" : "did not hold either");
  figure.x_label = axes.x_label;
  figure.y_label = axes.y_label;
  figure.x_range = {0, definition.duration};
  figure.spans = outside_window(definition);
  if (has_series(assessment.runs, row.reference, row.quantity))
    figure.curves.push_back(history_curve(assessment, row.reference, row.quantity, axes.scales));
  figure.curves.push_back(earlier_curve(earlier.result.at(row.quantity),
                                        row.candidate + " on " + earlier.date, axes.scales.value));
  figure.curves.push_back(history_curve(assessment, row.candidate, row.quantity, axes.scales));
  figure.curves.back().label = row.candidate + " now";
  figure.caption += cut_off_text(figure);
  return figure;
}

}  // namespace slosh

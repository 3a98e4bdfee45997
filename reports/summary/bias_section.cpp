#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "reports/figures/figure_runs.hpp"
#include "reports/summary/report_sections.hpp"

namespace slosh {
namespace {

using reports::Curve;
using reports::Figure;

constexpr std::size_t most_models = 5;      // of one figure, beside the line of agreement
constexpr double column_half_width = 0.36;  // of a model's column, the columns being 1 apart

// The places of `count` values side by side in the model's column.
std::vector<double> places(std::size_t column, std::size_t count) {
  std::vector<double> x;
  for (std::size_t i = 0; i < count; ++i)
    x.push_back(static_cast<double>(column) +
                column_half_width *
                    ((2.0 * static_cast<double>(i) + 1) / static_cast<double>(count) - 1));
  return x;
}

Curve ratios_of(const PredictionSet& set, std::size_t column, const reports::Look& look) {
  Curve points{.label = set.model,
               .x = places(column, set.predictions.size()),
               .style = Curve::Style::points,
               .look = look};
  for (const auto& one : set.predictions) {
    points.y.push_back(one.value.predicted / one.value.reference);
    // An interval that the fits do not tell has no bar.
    points.y_error.push_back(std::isfinite(one.ratio_half_width) ? one.ratio_half_width : 0);
  }
  return points;
}

// The model's bias across its column, with two standard deviations to either side as a ribbon.
Curve bias_of(const PredictionSet& set, std::size_t column, const reports::Look& look) {
  const double bias = set.bias->bias, width = 2 * set.bias->relative_deviation * bias,
               middle = static_cast<double>(column), half = column_half_width + 0.06;
  return {.label = "",
          .x = {middle - half, middle + half},
          .y = {bias, bias},
          .lower = {bias - width, bias - width},
          .upper = {bias + width, bias + width},
          .ribbon = "bias ± 2 standard deviations of the model",
          .look = look};
}

// `sets` are of one kind of quantity, each with a bias.
Figure ratio_figure(const std::vector<const PredictionSet*>& sets) {
  std::vector<std::string> models;
  for (const PredictionSet* set : sets) models.push_back(set->model);
  const std::vector<reports::Look> looks = looks_of_models(models);
  const std::string& kind = sets.front()->kind;
  const double last = static_cast<double>(sets.size()) - 0.5;
  Figure figure{
      .id = "bias-" + kind + "-ratio",
      .title = fmt::format("Predicted {} divided by the reference's", kind),
      .caption =
          "Each point is one comparison, in the order of the cases; 1 is perfect agreement. Bars: "
          "95 % interval of the ratio, from the fits of both series and the record's uncertainty. "
          "Shaded: the model's bias with two relative standard deviations to either side.",
      .x_label = "models, each with its number of comparisons",
      .y_label = "predicted / reference [1]",
      .x_range = {-0.5, last},
      .curves = {{.label = "perfect agreement",
                  .x = {-0.5, last},
                  .y = {1, 1},
                  .look = reports::Look{true, 0, 0}}}};
  std::ranges::replace(figure.id, ' ', '-');
  for (std::size_t i = 0; i < sets.size(); ++i) {
    figure.x_ticks.emplace_back(i, fmt::format("n = {}", sets[i]->predictions.size()));
    figure.curves.push_back(bias_of(*sets[i], i, looks[i]));
    figure.curves.push_back(ratios_of(*sets[i], i, looks[i]));
  }
  return figure;
}

reports::Table bias_table(const std::vector<PredictionSet>& sets) {
  reports::Table table{"bias",
                       "Bias and scatter of each model",
                       "A model with a bias of 1 is right on average. σ are relative standard "
                       "deviations: that of the model after subtracting that of the reference, and "
                       "that of the reference.",
                       {"quantity", "model", "comparisons", "bias δ", "σ of the model [%]",
                        "σ of the reference [%]"}};
  for (const PredictionSet& set : sets)
    if (set.bias)
      table.rows.push_back({set.kind, set.model, fmt::format("{}", set.bias->count),
                            fmt::format("{:.4f}", set.bias->bias),
                            fmt::format("{:.2f}", 100 * set.bias->relative_deviation),
                            fmt::format("{:.2f}", 100 * set.bias->reference_deviation)});
  return table;
}

}  // namespace

reports::Section bias_section(const std::vector<PredictionSet>& sets) {
  reports::Section section{
      "bias",
      "Bias and scatter",
      {"The mean and the standard deviation of ln(predicted / reference), after NIST's FDS "
       "validation guide (chapter 4; McGrattan and Toman 2011). For each model the finest run of "
       "every case is compared with theory in its range or with a record: amplitudes of the fitted "
       "modes, down to a tenth of the reference's largest, and natural frequencies. Gauges and "
       "modes of one run are not independent of each other, so the numbers describe only this set "
       "of comparisons."}};
  std::vector<std::string> few;
  for (const PredictionSet& set : sets)
    if (!set.bias)
      few.push_back(fmt::format("{} of {} ({})", set.kind, set.model, set.predictions.size()));
  if (!few.empty())
    section.paragraphs.push_back(
        fmt::format("Too few comparisons, fewer than {}, to state a bias: {}.", fewest_comparisons,
                    fmt::join(few, "; ")));
  if (sets.empty())
    section.paragraphs.push_back(
        "No case of this campaign compares a fitted mode with theory or a record.");
  if (std::ranges::none_of(sets, [](const auto& set) { return set.bias.has_value(); }))
    return section;
  section.tables.push_back(bias_table(sets));
  std::vector<const PredictionSet*> alike;  // of one figure
  std::size_t figures_of_kind = 0;
  const auto draw = [&] {
    section.figures.push_back(ratio_figure(alike));
    if (++figures_of_kind > 1) section.figures.back().id += fmt::format("-{}", figures_of_kind);
    alike.clear();
  };
  std::string kind;
  for (const PredictionSet& set : sets) {
    if (!set.bias) continue;
    if (!alike.empty() && (kind != set.kind || alike.size() == most_models)) draw();
    if (kind != set.kind) figures_of_kind = 0;
    kind = set.kind;
    alike.push_back(&set);
  }
  draw();
  return section;
}

}  // namespace slosh

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>

#include "reports/summary/report_sections.hpp"

namespace slosh {
namespace {

using reports::Curve;
using reports::Figure;

// The axis of a quantity; lengths are shown in millimetres.
struct Axis {
  std::string unit;
  double scale;
};

Axis axis_of(const std::string& unit) { return unit == "m" ? Axis{"mm", 1000} : Axis{unit, 1}; }

Curve points_of(const PredictionSet& set, double scale) {
  Curve points{set.model, {}, {}, {}, Curve::Style::points};
  for (const Prediction& one : set.predictions) {
    points.x.push_back(scale * one.value.reference);
    points.y.push_back(scale * one.value.predicted);
  }
  return points;
}

// The line predicted = factor * reference, over the whole width.
Curve line(const std::string& label, double factor, std::pair<double, double> width,
           Curve::Style style) {
  return {
      label, {width.first, width.second}, {factor * width.first, factor * width.second}, {}, style};
}

// Returns the range of both axes, with a margin.
std::pair<double, double> width_of(const std::vector<const PredictionSet*>& sets, double scale) {
  std::pair<double, double> width{std::numeric_limits<double>::infinity(), 0};
  for (const PredictionSet* set : sets)
    for (const Prediction& one : set->predictions) {
      width.first = std::min(width.first, scale * one.value.reference);
      width.second = std::max(width.second, scale * one.value.reference);
    }
  return {width.first / 1.2, width.second * 1.2};
}

// `sets` are of one kind of quantity, each with a bias; the lines show the first one's.
Figure scatter_figure(const std::vector<const PredictionSet*>& sets) {
  const PredictionSet& first = *sets.front();
  const auto [unit, scale] = axis_of(first.unit);
  const std::pair<double, double> width = width_of(sets, scale);
  const auto [count, bias, deviation, of_reference] = *first.bias;
  Figure figure;
  figure.id = "bias-" + first.kind;
  std::replace(figure.id.begin(), figure.id.end(), ' ', '-');
  figure.title = fmt::format("Predicted {} over the reference's", first.kind);
  figure.caption = fmt::format(
      "Full line: perfect agreement. Dashed lines: bias {:.3f} of {} and two relative standard "
      "deviations of {:.1f} % to either side.",
      bias, first.model, 100 * deviation);
  figure.x_label = fmt::format("reference [{}]", unit);
  figure.y_label = fmt::format("predicted [{}]", unit);
  figure.log_x = figure.log_y = width.second > 10 * width.first;
  figure.x_range = {width.first / 1.1, width.second * 1.1};  // the lines end inside
  for (const PredictionSet* set : sets) figure.curves.push_back(points_of(*set, scale));
  figure.curves.push_back(line("agreement", 1, width, Curve::Style::line));
  figure.curves.push_back(line(first.model + ": bias", bias, width, Curve::Style::dashed));
  for (const auto& [sign, factor] :
       {std::pair{"+", bias * (1 + 2 * deviation)}, std::pair{"−", bias * (1 - 2 * deviation)}})
    figure.curves.push_back(line(fmt::format("{}: bias {} 2 σ", first.model, sign), factor, width,
                                 Curve::Style::dashed));
  return figure;
}

// The same data as ratios, in which a scatter of one per cent is visible.
Figure ratio_figure(const std::vector<const PredictionSet*>& sets) {
  const PredictionSet& first = *sets.front();
  const double deviation = first.bias->relative_deviation;
  Figure figure = scatter_figure(sets);
  figure.id += "-ratio";
  figure.title = fmt::format("Predicted {} divided by the reference's", first.kind);
  figure.caption = fmt::format(
      "1 is perfect agreement; the band is the bias of {} with two relative standard deviations to "
      "either side.",
      first.model);
  figure.y_label = "predicted / reference";
  figure.log_y = false;
  figure.curves.resize(sets.size());
  for (Curve& curve : figure.curves)
    for (std::size_t i = 0; i < curve.y.size(); ++i) curve.y[i] /= curve.x[i];
  figure.bands = {{first.model + ": bias ± 2 σ", first.bias->bias * (1 - 2 * deviation),
                   first.bias->bias * (1 + 2 * deviation)}};
  return figure;
}

reports::Table bias_table(const std::vector<PredictionSet>& sets) {
  reports::Table table{"bias",
                       "Bias and scatter of each model",
                       "A model with a bias of 1 is right on average. σ are relative standard "
                       "deviations: that of the model after subtracting that of the reference, and "
                       "that of the reference.",
                       {"quantity", "model", "comparisons", "bias δ", "σ of the model [%]",
                        "σ of the reference [%]"},
                       {}};
  for (const PredictionSet& set : sets)
    if (set.bias)
      table.rows.push_back({set.kind, set.model, fmt::format("{}", set.bias->count),
                            fmt::format("{:.4f}", set.bias->bias),
                            fmt::format("{:.2f}", 100 * set.bias->relative_deviation),
                            fmt::format("{:.2f}", 100 * set.bias->reference_deviation)});
  return table;
}

std::string too_few_text(const std::vector<PredictionSet>& sets) {
  std::vector<std::string> few;
  for (const PredictionSet& set : sets)
    if (!set.bias)
      few.push_back(fmt::format("{} of {} ({})", set.kind, set.model, set.predictions.size()));
  return few.empty() ? ""
                     : fmt::format("Too few comparisons, fewer than {}, to state a bias: {}.",
                                   fewest_comparisons, fmt::join(few, "; "));
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
       "of comparisons."},
      {},
      {}};
  if (const std::string text = too_few_text(sets); !text.empty())
    section.paragraphs.push_back(text);
  if (sets.empty())
    section.paragraphs.push_back(
        "No case of this campaign compares a fitted mode with theory or a record.");
  if (std::none_of(sets.begin(), sets.end(), [](const auto& set) { return set.bias.has_value(); }))
    return section;
  section.tables.push_back(bias_table(sets));
  const auto draw = [&section](const std::vector<const PredictionSet*>& alike) {
    section.figures.push_back(scatter_figure(alike));
    section.figures.push_back(ratio_figure(alike));
  };
  std::vector<const PredictionSet*> alike;
  for (const PredictionSet& set : sets) {
    if (!set.bias) continue;
    if (!alike.empty() && alike.front()->kind != set.kind) {
      draw(alike);
      alike.clear();
    }
    alike.push_back(&set);
  }
  draw(alike);
  return section;
}

}  // namespace slosh

#include "reports/figures/figure_runs.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <stdexcept>
#include <tuple>

#include "reports/drawing/axes.hpp"
#include "reports/figures/run_looks.hpp"
#include "reports/model/is_one_of.hpp"
#include "reports/wording/shown_quantity.hpp"
#include "verification/case/motion.hpp"
#include "verification/case/quantities.hpp"
#include "verification/case/solver_kinds.hpp"

namespace slosh {
namespace {

std::vector<double> scaled(std::vector<double> values, double scale) {
  for (double& value : values) value *= scale;
  return values;
}

// Adds the band of the experiment's repeats, where the record has it of this quantity.
reports::Curve with_band(reports::Curve curve, const RunResult& record, const std::string& quantity,
                         double scale) {
  for (const TimeSeries& edge : record.series) {
    if (edge.name == quantity + lower_edge) curve.lower = scaled(edge.value, scale);
    if (edge.name == quantity + upper_edge) curve.upper = scaled(edge.value, scale);
  }
  if (curve.lower.size() != curve.y.size() || curve.upper.size() != curve.y.size()) {
    curve.lower.clear();
    curve.upper.clear();
  } else {
    curve.ribbon = "band of the experiment's repeats";
  }
  return curve;
}

}  // namespace

std::vector<std::string> finest_runs(const CaseAssessment& assessment,
                                     const std::function<bool(const RunResult&)>& has) {
  const auto preference = [](const RunDefinition& run) {
    const std::string changes = changes_of(run);
    return std::tuple{changes.empty(), resolution(run),
                      -std::count(changes.begin(), changes.end(), ',')};
  };
  std::vector<std::string> families;
  std::map<std::string, const RunDefinition*> finest;
  for (const RunDefinition& run : assessment.definition.runs) {
    const auto result = assessment.runs.results.find(run.name);
    if (result == assessment.runs.results.end() || !has(result->second)) continue;
    const RunDefinition*& best = finest[family(run)];
    if (!best) families.push_back(family(run));
    if (!best || preference(run) > preference(*best)) best = &run;
  }
  std::vector<std::string> names;
  for (const std::string& one : families) names.push_back(finest[one]->name);
  return names;
}

std::vector<std::string> finest_runs(const CaseAssessment& assessment,
                                     const std::string& quantity) {
  return finest_runs(assessment, [&](const RunResult& result) {
    return std::any_of(result.series.begin(), result.series.end(),
                       [&](const TimeSeries& series) { return series.name == quantity; });
  });
}

bool is_in_range(const CaseAssessment& assessment, const std::string& run) {
  return assessment.runs.status.at(run).state != RunState::out_of_range;
}

std::string run_label(const CaseAssessment& assessment, const std::string& run) {
  return is_in_range(assessment, run) ? run : run + " (out of its range)";
}

HistoryAxes axes_with_units(const CaseDefinition& definition, const std::string& quantity) {
  const ShownQuantity shown = shown_quantity(definition, quantity);
  return {{.value = shown.scale}, "time [s]", fmt::format("{} [{}]", shown.word, shown.unit)};
}

std::optional<HistoryAxes> axes_over_depth(const CaseDefinition& definition,
                                           const std::string& quantity) {
  const char* label = find_quantity(quantity)->label_over_depth;
  const double frequency = forcing_frequency(definition) / (2 * std::numbers::pi);
  if (!label || !(frequency > 0)) return std::nullopt;
  const double depth = definition.liquid.fill_depth;
  return HistoryAxes{{.time = frequency, .value = 1 / depth},
                     "time over the forcing period, t/T [1]",
                     label,
                     fmt::format("h = {:.4g} m, T = {:.4g} s. ", depth, 1 / frequency)};
}

// More points would overlap.
constexpr std::size_t most_points = 200;

reports::Curve history_curve(const CaseAssessment& assessment, const std::string& run,
                             const std::string& quantity, const AxisScales& scales) {
  const TimeSeries& series = assessment.runs.results.at(run).at(quantity);
  reports::Curve curve{run_label(assessment, run),
                       scaled(series.time, scales.time),
                       scaled(series.value, scales.value),
                       {},
                       {}};
  curve.look = look_of(assessment.definition, run);
  curve.sets_scale = is_in_range(assessment, run);
  if (const auto* record = std::get_if<RecordRun>(&run_named(assessment.definition, run).solver)) {
    if (record->has_band)
      return with_band(std::move(curve), assessment.runs.results.at(run), quantity, scales.value);
    if (record->time.size() <= most_points) curve.style = reports::Curve::Style::points;
    if (record->uncertainty)
      set_uncertainty(curve, std::vector(curve.y.size(), scales.value * *record->uncertainty),
                      "95 % interval of the record");
  }
  return curve;
}

void set_uncertainty(reports::Curve& curve, const std::vector<double>& half_widths,
                     const std::string& what) {
  if (half_widths.size() != curve.y.size())
    throw std::invalid_argument(fmt::format("{}: {} half widths of {} samples", curve.label,
                                            half_widths.size(), curve.y.size()));
  if (curve.style == reports::Curve::Style::points) {
    curve.y_error = half_widths;
    return;
  }
  for (std::size_t i = 0; i < curve.y.size(); ++i) {
    curve.lower.push_back(curve.y[i] - half_widths[i]);
    curve.upper.push_back(curve.y[i] + half_widths[i]);
  }
  curve.ribbon = what;
}

void add_tolerance_band(reports::Band band, reports::Figure& figure) {
  const auto is_near = [](double one, double other) {
    return std::abs(one - other) <= 1e-6 * std::abs(one);
  };
  for (reports::Band& known : figure.bands)
    if (is_near(known.lower, band.lower) && is_near(known.upper, band.upper)) {
      known.label += ", " + band.label;
      known.look = {};
      return;
    }
  band.label = "tolerance, " + band.label;
  figure.bands.push_back(std::move(band));
}

void let_most_set_scale(reports::Figure& figure,
                        const std::function<double(const reports::Curve&)>& size) {
  constexpr std::size_t fewest = 3;
  constexpr double far = 4;
  std::vector<double> sizes;
  for (const reports::Curve& curve : figure.curves)
    if (curve.look && !curve.look->is_reference) sizes.push_back(size(curve));
  if (sizes.size() < fewest) return;
  const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>((sizes.size() - 1) / 2);
  std::nth_element(sizes.begin(), middle, sizes.end());
  if (!(*middle > 0)) return;
  for (reports::Curve& curve : figure.curves)
    if (curve.look && !curve.look->is_reference && size(curve) > far * *middle)
      curve.sets_scale = false;
}

double farthest_from(double level, const reports::Curve& curve) {
  double farthest = 0;
  for (const double value : curve.y)
    if (std::isfinite(value)) farthest = std::max(farthest, std::abs(value - level));
  return farthest;
}

std::string cut_off_text(const reports::Figure& figure) {
  const reports::AxisRange frame = reports::plot_ranges(figure).vertical;
  std::string text;
  for (const reports::Curve& curve : figure.curves) {
    if (curve.sets_scale) continue;
    double lowest = INFINITY, highest = -INFINITY;
    for (const double value : curve.y)
      if (std::isfinite(value)) {
        lowest = std::min(lowest, value);
        highest = std::max(highest, value);
      }
    if (lowest < frame.lower || highest > frame.upper)
      text += fmt::format(
          " The thin line of {} is cut off at the frame, which is scaled to the other curves: it "
          "lies between {:.3g} and {:.3g}.",
          curve.label, lowest, highest);
  }
  return text;
}

std::vector<const Comparison*> shown_comparisons(const CaseAssessment& assessment) {
  const std::vector<std::string> finest =
      finest_runs(assessment, compared_quantities(assessment.definition).front());
  std::vector<const Comparison*> shown = judging_comparisons(assessment);
  std::erase_if(shown, [&](const Comparison* one) { return !is_one_of(one->candidate, finest); });
  return shown;
}

std::vector<reports::Span> outside_window(const CaseDefinition& definition, double time_scale) {
  std::vector<reports::Span> spans;
  for (const auto& [begin, end] : {std::pair{0.0, definition.window_begin},
                                   std::pair{definition.window_end, definition.duration}})
    if (begin < end)
      spans.push_back({"outside the comparison window", time_scale * begin, time_scale * end});
  return spans;
}

std::string who_is_who(const CaseDefinition& definition, const std::vector<std::string>& runs) {
  std::vector<std::string> texts;
  bool bars = false;
  std::string bands;
  for (const std::string& name : runs) {
    const RunDefinition& run = run_named(definition, name);
    texts.push_back(name + ": " + caption_text(run));
    const auto* record = std::get_if<RecordRun>(&run.solver);
    bars |= record && record->uncertainty && !record->has_band;
    if (record && record->has_band)
      bands += fmt::format(
          " The ribbon about {} is the band of the experiment's repeats, from a lower to an upper "
          "quantile.",
          name);
  }
  return fmt::format("{}.{}{}", fmt::join(texts, "; "),
                     bars ? " Bars, or a ribbon, show the 95 % interval of a record." : "", bands);
}

}  // namespace slosh

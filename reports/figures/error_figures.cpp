// The error of each method against its run time and its memory, with the Pareto front, and against
// spacing, with the fitted order and its band and guides of first and second order.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "reports/figures/case_figures.hpp"
#include "reports/figures/figure_runs.hpp"
#include "reports/wording/case_text.hpp"
#include "verification/assessment/across_runs/speed_ups.hpp"
#include "verification/assessment/observed_order.hpp"
#include "verification/assessment/work_points.hpp"
#include "verification/series/interval_text.hpp"

namespace slosh {
namespace {

using reports::Curve;
using reports::Figure;

constexpr double mm_per_m = 1000;
// The band is clipped at this factor beyond the errors: with three points it would fill the figure.
constexpr double band_reach = 3;

// The smallest and the largest of the values above zero.
std::pair<double, double> extent_of(const std::vector<double>& values) {
  double low = INFINITY, high = 0;
  for (const double value : values)
    if (value > 0) {
      low = std::min(low, value);
      high = std::max(high, value);
    }
  return {low, high};
}

Curve error_points(const ErrorFamily& family) {
  Curve points{.label = "error, with its 95 % interval", .style = Curve::Style::points};
  for (const auto& [spacing, error] : family.errors) {
    points.x.push_back(mm_per_m * spacing);
    points.y.push_back(family.scale * std::abs(error.value));
    points.y_error.push_back(family.scale * error.half_width);
  }
  return points;
}

Curve fitted_line(const PowerLawLine& line, const Curve& points, double scale) {
  Curve curve{.label = "least squares: order " + slope_text(line.order),
              .ribbon = "95 % band of the line",
              .look = reports::Look{true, 0, 0}};
  constexpr int count = 41;  // of spacings at equal distances on a logarithmic axis
  const auto [finest, coarsest] = extent_of(points.x);
  const auto [least, most] = extent_of(points.y);
  for (int i = 0; i < count; ++i)
    curve.x.push_back(finest * std::pow(coarsest / finest, i / (count - 1.0)));
  const auto cut = [low = least / band_reach, high = most * band_reach](double value) {
    return std::clamp(value, low, high);
  };
  for (const double spacing : curve.x) {
    const auto [value, lower, upper] = line.at(spacing / mm_per_m);
    curve.y.push_back(scale * value);
    curve.lower.push_back(cut(scale * lower));
    curve.upper.push_back(cut(scale * upper));
  }
  return curve;
}

// A line of the given order through the fitted line's value at the coarsest spacing.
Curve guide(int order, const Curve& line) {
  return {.label = fmt::format("order {}", order),
          .x = {line.x.front(), line.x.back()},
          .y = {line.y.back() * std::pow(line.x.front() / line.x.back(), order), line.y.back()},
          .style = Curve::Style::dashed,
          .look = guide_look(static_cast<std::size_t>(order - 1))};
}

// Returns "normalised_rms" for "normalised rms [%]", as a part of an id.
std::string id_part(std::string measure) {
  measure.resize(std::min(measure.size(), measure.find(" [")));
  std::ranges::replace_if(
      measure, [](char c) { return c < 'a' || c > 'z'; }, '_');
  return measure;
}

// A figure shows no more changes one by one.
constexpr std::size_t most_changes_named = 6;
const std::string many_changes = ", one change";

// A kind of cost, and how a figure shows it.
struct CostAxis {
  std::vector<WorkPoint> (*points)(const WorkFamily&);
  double scale;  // from the points' unit to the axis'
  std::string id, title, what, x_label;
};

const CostAxis time_axis{by_core_seconds,
                         1,
                         "-cost",
                         "Error against run time",
                         "core-seconds of the run (user and system time, all processes)",
                         "run time [core-s]"};
const CostAxis memory_axis{by_memory,
                           1.0 / 1048576,
                           "-memory",
                           "Error against memory",
                           "the peak memory of the run's largest process",
                           "peak memory [MiB]"};

// Names every change, or gathers many of them under one name.
std::vector<WorkFamily> shown_families(const CaseAssessment& assessment) {
  std::vector<WorkFamily> families = work_families(assessment);
  const auto changes = std::count_if(families.begin(), families.end(),
                                     [](const WorkFamily& one) { return one.changed; });
  if (changes <= static_cast<std::ptrdiff_t>(most_changes_named)) return families;
  std::vector<WorkFamily> shown;
  for (WorkFamily& family : families) {
    if (family.changed) family.name = family.name.substr(0, family.name.find(',')) + many_changes;
    const auto same = std::find_if(shown.begin(), shown.end(), [&](const WorkFamily& one) {
      return one.name == family.name && one.reference == family.reference;
    });
    if (same == shown.end())
      shown.push_back(std::move(family));
    else
      same->runs.insert(same->runs.end(), family.runs.begin(), family.runs.end());
  }
  return shown;
}

// The reference of all of these families; empty where they have several.
std::string common_reference(const std::vector<WorkFamily>& families) {
  const bool is_common = std::all_of(families.begin(), families.end(), [&](const WorkFamily& one) {
    return one.reference == families.front().reference;
  });
  return is_common && !families.empty() ? families.front().reference : "";
}

// The label names the reference where the figure has several.
Curve curve_of(const CaseDefinition& definition, const WorkFamily& family, const CostAxis& axis,
               bool names_reference) {
  const std::vector<WorkPoint> points = axis.points(family);
  const bool is_one_method = !family.name.ends_with(many_changes);
  const auto slope = is_one_method ? work_slope(points) : std::nullopt;
  Curve curve{.label = family.name + (names_reference ? " against " + family.reference : "") +
                       (slope ? ", slope " + slope_text(*slope) : ""),
              .style = slope ? Curve::Style::line_points : Curve::Style::points,
              .look = look_of(definition, family.runs.back().run)};
  for (const WorkPoint& point : points) {
    curve.x.push_back(axis.scale * point.cost.value);
    curve.x_error.push_back(axis.scale * point.cost.half_width);
    curve.y.push_back(point.error.value);
    curve.y_error.push_back(point.error.half_width);
  }
  for (std::vector<double>* bars : {&curve.x_error, &curve.y_error})
    if (std::none_of(bars->begin(), bars->end(), [](double bar) { return bar > 0; })) bars->clear();
  return curve;
}

// Returns a stepped line from above the cheapest run to the right of the most accurate one.
Curve front_curve(const std::vector<WorkPoint>& points, const CostAxis& axis) {
  Curve curve{.label = "Pareto front", .style = Curve::Style::dashed, .look = guide_look(0)};
  double worst = 0, dearest = 0;
  for (const WorkPoint& point : points) {
    if (std::isfinite(point.error.value)) worst = std::max(worst, point.error.value);
    if (std::isfinite(point.cost.value)) dearest = std::max(dearest, point.cost.value);
  }
  double level = worst;
  for (const WorkPoint& point : pareto_front(points)) {
    for (const double y : {level, point.error.value}) {
      curve.x.push_back(axis.scale * point.cost.value);
      curve.y.push_back(y);
    }
    level = point.error.value;
  }
  curve.x.push_back(axis.scale * dearest);
  curve.y.push_back(level);
  return curve;
}

// Tells which costs were not measured alone on a core of this machine.
std::string remarks_on_costs(const std::vector<WorkFamily>& families) {
  std::size_t timed = 0;
  std::vector<std::string> untimed, elsewhere;
  for (const WorkFamily& family : families)
    for (const WorkRun& run : family.runs) {
      if (run.cost.elsewhere)
        elsewhere.push_back(run.run);
      else if (run.cost.timings == 0)
        untimed.push_back(run.run);
      else
        ++timed;
    }
  std::string text;
  if (!untimed.empty())
    text += timed == 0 ? " All costs were measured once, while other runs were running, and have "
                         "no bar."
                       : fmt::format(
                             " Measured once, while other runs were running, and shown "
                             "without a bar of cost: {}.",
                             fmt::join(untimed, ", "));
  if (!elsewhere.empty())
    text += fmt::format(" Stored results, with costs of other machines: {}.",
                        fmt::join(elsewhere, ", "));
  return text;
}

Figure figure_of(const CaseAssessment& assessment, const CostAxis& axis) {
  const std::vector<WorkFamily> families = shown_families(assessment);
  const std::vector<WorkFamily> references = reference_families(assessment);
  Figure figure{.id = case_id(assessment.definition.name) + axis.id,
                .title = axis.title,
                .x_label = axis.x_label,
                .y_label = "normalised rms error [1]",
                .log_x = true,
                .log_y = true};
  std::vector<WorkPoint> candidates;
  for (const WorkFamily& family : families) {
    const std::vector<WorkPoint> points = axis.points(family);
    candidates.insert(candidates.end(), points.begin(), points.end());
  }
  if (candidates.size() > 1 && !pareto_front(candidates).empty())
    figure.curves.push_back(front_curve(candidates, axis));
  const std::string reference = references.empty() ? common_reference(families) : "";
  for (const auto* group : {&families, &references})
    for (const WorkFamily& family : *group)
      if (!axis.points(family).empty())
        figure.curves.push_back(curve_of(assessment.definition, family, axis, reference.empty()));
  figure.caption = fmt::format(
      "Normalised rms error{} over the comparison window against {}. Bars are 95 % intervals: of "
      "the mean cost of repeats that had a core to themselves, and of the error over blocks of the "
      "window. The Pareto front includes all candidates; the slope is that of ln(error) over "
      "ln(cost).{}{}",
      reference.empty() ? "" : " from " + reference, axis.what,
      references.empty() ? ""
                         : " The error of a reference is its difference from another reference.",
      remarks_on_costs(families));
  return figure;
}

}  // namespace

std::vector<Figure> convergence_figures(const CaseAssessment& assessment) {
  const CaseDefinition& definition = assessment.definition;
  std::vector<Figure> figures;
  for (const ErrorFamily& family : error_families(assessment)) {
    const auto line = least_squares_line(family.errors);
    if (!line) continue;
    const std::string what = family.measure.substr(0, family.measure.find(" ["));
    Figure figure{
        .id = fmt::format("{}-convergence-{}-{}", case_id(definition.name), name_id(family.name),
                          id_part(family.measure)),
        .title = fmt::format("Convergence: {}, {}", family.name, what),
        .caption = fmt::format(
            "Magnitude of the {} against theory or a published record, over the particle spacing "
            "or the root of a cell's area. Line: least squares through the logarithms of those "
            "errors that are larger than their own intervals; the ribbon is its 95 % band "
            "(Student's t), clipped at {:.0f} times the errors. The order is given with its 95 % "
            "interval.",
            what, band_reach),
        .x_label = "spacing [mm]",
        .y_label = family.measure,
        .log_x = true,
        .log_y = true,
        .curves = {error_points(family)}};
    figure.curves.push_back(fitted_line(*line, figure.curves[0], family.scale));
    figure.curves[0].look = look_of_family(definition, family.name);
    for (const int order : {1, 2}) figure.curves.push_back(guide(order, figure.curves[1]));
    figures.push_back(std::move(figure));
  }
  return figures;
}

std::vector<Figure> cost_figures(const CaseAssessment& assessment) {
  if (judging_comparisons(assessment).empty()) return {};
  std::vector<Figure> figures{figure_of(assessment, memory_axis)};
  if (equal_error_speeds(assessment).empty())
    figures.insert(figures.begin(), figure_of(assessment, time_axis));
  return figures;
}

std::optional<Figure> speed_figure(const CaseAssessment& assessment) {
  const std::vector<EqualErrorSpeed> speeds = equal_error_speeds(assessment);
  if (speeds.empty()) return {};
  Figure figure = figure_of(assessment, time_axis);
  figure.title += ": " + assessment.definition.title;
  std::vector<std::string> texts;
  for (const EqualErrorSpeed& speed : speeds) texts.push_back(speed_text(speed));
  figure.caption = fmt::format("{}. {}", fmt::join(texts, "; "), figure.caption);
  return figure;
}

}  // namespace slosh

// Error against spacing with the fitted order and its band, and guides of first and second order.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/figures/case_figures.hpp"
#include "reports/figures/run_looks.hpp"
#include "reports/wording/report_places.hpp"
#include "verification/assessment/observed_order.hpp"
#include "verification/series/interval_text.hpp"

namespace slosh {
namespace {

using reports::Curve;
using reports::Figure;

constexpr double mm_per_m = 1000;
// The band is clipped at this factor beyond the errors: with three points it would fill the figure.
constexpr double band_reach = 3;

struct Extent {
  double low, high;
};

Extent extent_of(const std::vector<double>& values) {
  Extent extent{INFINITY, 0};
  for (const double value : values)
    if (value > 0) extent = {std::min(extent.low, value), std::max(extent.high, value)};
  return extent;
}

// Returns spacings at equal distances on a logarithmic axis.
std::vector<double> spacings_between(const Extent& extent) {
  constexpr int count = 41;
  std::vector<double> spacings;
  for (int i = 0; i < count; ++i)
    spacings.push_back(extent.low * std::pow(extent.high / extent.low, i / (count - 1.0)));
  return spacings;
}

Curve error_points(const ErrorFamily& family) {
  Curve points{"error, with its 95 % interval", {}, {}, {}, Curve::Style::points};
  for (const auto& [spacing, error] : family.errors) {
    points.x.push_back(mm_per_m * spacing);
    points.y.push_back(family.scale * std::abs(error.value));
    points.y_error.push_back(family.scale * error.half_width);
  }
  return points;
}

Curve fitted_line(const PowerLawLine& line, const Curve& points, double scale) {
  Curve curve{"least squares: order " + slope_text(line.order),
              spacings_between(extent_of(points.x)),
              {},
              {},
              Curve::Style::line};
  const Extent errors = extent_of(points.y);
  const auto cut = [&](double value) {
    return std::clamp(value, errors.low / band_reach, errors.high * band_reach);
  };
  for (const double spacing : curve.x) {
    const auto [value, lower, upper] = line.at(spacing / mm_per_m);
    curve.y.push_back(scale * value);
    curve.lower.push_back(cut(scale * lower));
    curve.upper.push_back(cut(scale * upper));
  }
  curve.ribbon = "95 % band of the line";
  return curve;
}

// A line of the given order through the fitted line's value at the coarsest spacing.
Curve guide(int order, const Curve& line) {
  Curve curve{fmt::format("order {}", order),
              {line.x.front(), line.x.back()},
              {line.y.back() * std::pow(line.x.front() / line.x.back(), order), line.y.back()},
              {},
              Curve::Style::dashed};
  curve.look = guide_look(static_cast<std::size_t>(order - 1));
  return curve;
}

// Returns "normalised_rms" for "normalised rms [%]", as a part of an id.
std::string id_part(std::string measure) {
  measure.resize(std::min(measure.size(), measure.find(" [")));
  std::replace_if(
      measure.begin(), measure.end(), [](char c) { return c < 'a' || c > 'z'; }, '_');
  return measure;
}

}  // namespace

std::vector<Figure> convergence_figures(const CaseAssessment& assessment) {
  const CaseDefinition& definition = assessment.definition;
  std::vector<Figure> figures;
  for (const ErrorFamily& family : error_families(assessment)) {
    const auto line = least_squares_line(family.errors);
    if (!line) continue;
    Figure figure;
    const std::string what = family.measure.substr(0, family.measure.find(" ["));
    figure.id = fmt::format("{}-convergence-{}-{}", case_id(definition.name), name_id(family.name),
                            id_part(family.measure));
    figure.title = fmt::format("Convergence: {}, {}", family.name, what);
    figure.caption = fmt::format(
        "Magnitude of the {} against theory or a published record, over the particle spacing or "
        "the root of a cell's area. Line: least squares through the logarithms of those errors "
        "that are larger than their own intervals; the ribbon is its 95 % band (Student's t), "
        "clipped at {:.0f} times the errors. The order is given with its 95 % interval.",
        what, band_reach);
    figure.x_label = "spacing [mm]";
    figure.y_label = family.measure;
    figure.log_x = figure.log_y = true;
    figure.curves = {error_points(family)};
    figure.curves.push_back(fitted_line(*line, figure.curves[0], family.scale));
    figure.curves[0].look = look_of_family(definition, family.name);
    figure.curves[1].look = reports::Look{true, 0, 0};
    for (const int order : {1, 2}) figure.curves.push_back(guide(order, figure.curves[1]));
    figures.push_back(std::move(figure));
  }
  return figures;
}

}  // namespace slosh

// Amplitude and phase of each fitted mode in one figure: the candidate's complex amplitude over its
// reference's,
//   A_c / A_r exp(-i lag),   lag = phi_r - phi_c.
// A perfect candidate lies at (1, 0), a late one below the axis, one with too large an amplitude
// outside the unit circle. The interval of amplitude error and lag is an ellipse with half axes
// d(A_c / A_r) along the phasor and (A_c / A_r) d(lag) across it; the bars are its bounding box.
//
// Whether a candidate stays in phase with its reference: amplitude ratio and phase lag of the
// forced mode, or of the first natural mode without forcing, over sliding windows.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "reports/drawing/figure_layout.hpp"
#include "reports/figures/case_figures.hpp"
#include "reports/figures/figure_runs.hpp"
#include "reports/wording/case_text.hpp"
#include "reports/wording/shown_quantity.hpp"
#include "verification/case/quantities.hpp"
#include "verification/gate/gate.hpp"
#include "verification/metrics/sliding_fit.hpp"
#include "verification/series/time_series.hpp"

namespace slosh {
namespace {

using reports::Curve;
using reports::Figure;

constexpr double periods_per_window = 3, windows_per_period = 4;
constexpr double most_windows = 60;        // more are not visible
constexpr std::size_t fewest_windows = 4;  // fewer do not show a drift

SlidingWindows windows_of(const CaseDefinition& definition, const ToneRequest& tone) {
  const double period = 2 * std::numbers::pi / tone.angular_frequency;
  const double length = periods_per_window * period;
  const double room = definition.window_end - definition.window_begin - length;
  return {length, std::max(period / windows_per_period, room / most_windows)};
}

// Returns nullopt where the pair cannot be fitted or has too few windows.
std::optional<std::vector<FittedWindow>> fits_of(const CaseAssessment& assessment,
                                                 const Comparison& pair,
                                                 const SlidingWindows& sliding,
                                                 const std::vector<ToneRequest>& tones) try {
  const auto& results = assessment.runs.results;
  std::vector<FittedWindow> fits =
      sliding_fit(results.at(pair.candidate).at(pair.quantity),
                  results.at(pair.reference).at(pair.quantity), pair.window, sliding, tones);
  if (fits.size() < fewest_windows) return std::nullopt;
  return fits;
} catch (const ComparisonError&) {
  return std::nullopt;
}

// The curve has a gap where the mode is not resolved.
Curve curve_of(const CaseDefinition& definition, const Comparison& pair,
               const std::vector<FittedWindow>& fits, Estimate ModeComparison::*measure,
               double offset) {
  Curve curve{.label = pair.candidate + " against " + pair.reference,
              .ribbon = "95 % interval",
              .look = look_of(definition, pair.candidate)};
  for (const FittedWindow& fit : fits) {
    const ModeComparison& mode = fit.modes.front();
    const Estimate value = mode.resolved() ? mode.*measure : Estimate{not_a_number, 0};
    curve.x.push_back(fit.middle);
    curve.y.push_back(offset + value.value);
    curve.lower.push_back(offset + value.value - value.half_width);
    curve.upper.push_back(offset + value.value + value.half_width);
  }
  return curve;
}

void add_band(const CaseDefinition& definition, const Comparison& pair, const std::string& mode,
              Metric metric, double offset, Figure& figure) {
  if (const auto allowed = tolerance_of(definition, pair, mode, metric))
    add_tolerance_band({pair.candidate, offset + allowed->lower, offset + allowed->upper,
                        look_of(definition, pair.candidate)},
                       figure);
}

std::string sliding_caption(const CaseDefinition& definition, const std::vector<ToneRequest>& tones,
                            const SlidingWindows& sliding) {
  std::string others;
  for (std::size_t i = 1; i < tones.size(); ++i) others += (i > 1 ? ", " : "") + tones[i].name;
  return fmt::format(
      "The {}, mode {}: harmonic least squares over windows of {:.3g} s ({:.0f} periods) every "
      "{:.2g} s, plotted at their midpoints{}; ribbons are 95 % intervals. A window cannot "
      "separate the mode from a neighbouring mode that beats with it, so the curve includes that "
      "beat.",
      shown_quantity(definition, compared_quantities(definition).front()).word, tones[0].name,
      sliding.length, periods_per_window, sliding.step,
      others.empty() ? "" : ", fitted together with " + others);
}

constexpr double radian_per_degree = std::numbers::pi / 180;

void add_point(Curve& curve, double ratio, double lag) {
  curve.x.push_back(ratio * std::cos(lag));
  curve.y.push_back(-ratio * std::sin(lag));
}

Curve phasor(const std::string& label, const reports::Look& look, const ModeComparison& mode) {
  const double ratio = 1 + mode.amplitude_error.value;
  const double lag = mode.phase_lag_degrees.value * radian_per_degree;
  const double along = mode.amplitude_error.half_width;
  const double across = ratio * mode.phase_lag_degrees.half_width * radian_per_degree;
  Curve curve{.label = label, .style = Curve::Style::points, .look = look};
  add_point(curve, ratio, lag);
  curve.x_error = {std::hypot(along * std::cos(lag), across * std::sin(lag))};
  curve.y_error = {std::hypot(along * std::sin(lag), across * std::cos(lag))};
  return curve;
}

// The sector that gate rows allow, as amplitude ratio and lag [rad]. Where only one of the two has
// a row, the edges of that one are drawn over this default extent of the other.
struct Sector {
  double ratio_low = 0.9, ratio_high = 1.1;
  double lag_low = -10 * radian_per_degree, lag_high = 10 * radian_per_degree;
  bool of_ratio = false, of_lag = false;
};

Sector sector_of(const CaseDefinition& definition, const Comparison& comparison,
                 const std::string& mode) {
  Sector sector;
  if (const auto allowed = tolerance_of(definition, comparison, mode, Metric::amplitude_error)) {
    sector.ratio_low = 1 + allowed->lower;
    sector.ratio_high = 1 + allowed->upper;
    sector.of_ratio = true;
  }
  if (const auto allowed = tolerance_of(definition, comparison, mode, Metric::phase_lag)) {
    sector.lag_low = allowed->lower * radian_per_degree;
    sector.lag_high = allowed->upper * radian_per_degree;
    sector.of_lag = true;
  }
  return sector;
}

void add_arc(Curve& curve, double ratio, double from, double to) {
  constexpr int pieces = 40;
  for (int i = 0; i <= pieces; ++i) add_point(curve, ratio, from + (to - from) * i / pieces);
}

void add_gap(Curve& curve) { add_point(curve, not_a_number, 0); }

// Returns a closed line around the sector, or two open edges where only one row stands.
Curve outline(const std::string& label, const Sector& sector) {
  Curve curve{.label = label, .style = Curve::Style::dashed};
  if (!sector.of_ratio) {
    for (const double lag : {sector.lag_low, sector.lag_high}) {
      add_point(curve, sector.ratio_low, lag);
      add_point(curve, sector.ratio_high, lag);
      add_gap(curve);
    }
    return curve;
  }
  add_arc(curve, sector.ratio_low, sector.lag_low, sector.lag_high);
  if (!sector.of_lag) add_gap(curve);
  add_arc(curve, sector.ratio_high, sector.lag_high, sector.lag_low);
  if (sector.of_lag) add_point(curve, sector.ratio_low, sector.lag_low);
  return curve;
}

// Candidates whose rows allow the same share one line.
void add_tolerance(const std::string& candidate, const Sector& sector,
                   std::vector<Curve>& outlines) {
  if (!sector.of_ratio && !sector.of_lag) return;
  Curve curve = outline("tolerance, " + candidate, sector);
  const auto same = std::find_if(outlines.begin(), outlines.end(), [&](const Curve& other) {
    return other.x == curve.x && other.y == curve.y;
  });
  if (same == outlines.end()) {
    curve.look = guide_look(outlines.size());
    outlines.push_back(std::move(curve));
  } else {
    same->label += ", " + candidate;
  }
}

Figure phasor_figure(const CaseAssessment& assessment, const std::string& mode) {
  const CaseDefinition& definition = assessment.definition;
  Figure figure{.id = case_id(definition.name) + "-phasor-" + mode,
                .title = "Amplitude and phase of the mode " + mode,
                .x_label = "in phase, Re [1]",
                .y_label = "in quadrature, Im [1]",
                .curves = {{.label = "reference, (1, 0)",
                            .x = {1},
                            .y = {0},
                            .style = Curve::Style::points,
                            .look = reports::Look{true, 0, 0}}},
                .equal_axes = true};
  std::vector<Curve> outlines;
  std::vector<std::string> runs;
  for (const Comparison* shown : shown_comparisons(assessment))
    for (const ModeComparison& one : shown->modes) {
      if (one.mode != mode || !one.resolved()) continue;
      figure.curves.push_back(phasor(shown->candidate + " over " + shown->reference,
                                     look_of(definition, shown->candidate), one));
      add_tolerance(shown->candidate, sector_of(definition, *shown, mode), outlines);
      runs.push_back(shown->candidate);
    }
  if (runs.empty()) return {};
  figure.curves.insert(figure.curves.end(), outlines.begin(), outlines.end());
  figure.caption = fmt::format(
      "The {}: complex amplitude of the candidate over that of its reference, from the harmonic "
      "fit over {:g} to {:g} s. A point below the axis is late, one outside the unit circle has "
      "too large an amplitude; 1 deg is 0.017 along the circle. Bars enclose the 95 % interval of "
      "amplitude and lag. {}{}",
      shown_quantity(definition, compared_quantities(definition).front()).word,
      definition.window_begin, definition.window_end,
      outlines.empty() ? ""
                       : "Dashed: bounds of the gate rows; a row passes where the whole "
                         "interval lies within. ",
      who_is_who(definition, runs));
  let_most_set_scale(figure,
                     [](const Curve& curve) { return std::hypot(curve.x[0] - 1, curve.y[0]); });
  const auto [horizontal, vertical] = reports::plot_ranges(figure);
  for (const Curve& curve : figure.curves)
    if (!curve.sets_scale && !(horizontal.lower < curve.x[0] && curve.x[0] < horizontal.upper &&
                               vertical.lower < curve.y[0] && curve.y[0] < vertical.upper))
      figure.caption += fmt::format(" {} lies outside of the frame, at {:.3g}, {:.3g}.",
                                    curve.label, curve.x[0], curve.y[0]);
  return figure;
}

}  // namespace

std::vector<Figure> sliding_figures(const CaseAssessment& assessment) {
  const CaseDefinition& definition = assessment.definition;
  const std::vector<ToneRequest> modes = fitted_modes(definition);
  if (modes.empty()) return {};
  const SlidingWindows sliding = windows_of(definition, modes.front());
  const std::vector<ToneRequest> tones = resolved_tones(modes, sliding.length);
  Figure ratio{.id = case_id(definition.name) + "-sliding-amplitude",
               .title = "Amplitude ratio over time",
               .caption = sliding_caption(definition, tones, sliding),
               .x_label = "midpoint of the window [s]",
               .y_label = "amplitude over the reference's [1]"};
  Figure lag{.id = case_id(definition.name) + "-sliding-lag",
             .title = "Phase lag over time",
             .caption = ratio.caption,
             .x_label = ratio.x_label,
             .y_label = "phase lag [deg] (positive: late)"};
  for (const Comparison* pair : shown_comparisons(assessment)) {
    const auto fits = fits_of(assessment, *pair, sliding, tones);
    if (!fits) continue;
    ratio.curves.push_back(curve_of(definition, *pair, *fits, &ModeComparison::amplitude_error, 1));
    lag.curves.push_back(curve_of(definition, *pair, *fits, &ModeComparison::phase_lag_degrees, 0));
    add_band(definition, *pair, tones[0].name, Metric::amplitude_error, 1, ratio);
    add_band(definition, *pair, tones[0].name, Metric::phase_lag, 0, lag);
  }
  if (ratio.curves.empty()) return {};
  let_most_set_scale(ratio, [](const Curve& curve) { return farthest_from(1, curve); });
  let_most_set_scale(lag, [](const Curve& curve) { return farthest_from(0, curve); });
  for (Figure* figure : {&ratio, &lag}) figure->caption += cut_off_text(*figure);
  return {ratio, lag};
}

std::vector<Figure> phasor_figures(const CaseAssessment& assessment) {
  std::vector<Figure> figures;
  for (const ToneRequest& mode : fitted_modes(assessment.definition)) {
    Figure figure = phasor_figure(assessment, mode.name);
    if (!figure.curves.empty()) figures.push_back(std::move(figure));
  }
  return figures;
}

}  // namespace slosh

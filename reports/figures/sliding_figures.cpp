// Whether a candidate stays in phase with its reference: amplitude ratio and phase lag of the
// forced mode, or of the first natural mode without forcing, over sliding windows.
#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <optional>

#include "reports/figures/case_figures.hpp"
#include "reports/figures/figure_runs.hpp"
#include "reports/figures/run_looks.hpp"
#include "reports/wording/report_places.hpp"
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
  Curve curve{pair.candidate + " against " + pair.reference, {}, {}, {}, Curve::Style::line};
  curve.look = look_of(definition, pair.candidate);
  for (const FittedWindow& fit : fits) {
    const ModeComparison& mode = fit.modes.front();
    const Estimate value = mode.resolved() ? mode.*measure : Estimate{not_a_number, 0};
    curve.x.push_back(fit.middle);
    curve.y.push_back(offset + value.value);
    curve.lower.push_back(offset + value.value - value.half_width);
    curve.upper.push_back(offset + value.value + value.half_width);
  }
  curve.ribbon = "95 % interval";
  return curve;
}

void add_band(const CaseDefinition& definition, const Comparison& pair, const std::string& mode,
              Metric metric, double offset, Figure& figure) {
  if (const auto allowed = tolerance_of(definition, pair, mode, metric))
    figure.bands.push_back({"tolerance, " + pair.candidate, offset + allowed->lower,
                            offset + allowed->upper, look_of(definition, pair.candidate)});
}

Figure frame(const CaseDefinition& definition, const std::vector<ToneRequest>& tones,
             const SlidingWindows& sliding) {
  Figure figure;
  std::string others;
  for (std::size_t i = 1; i < tones.size(); ++i) others += (i > 1 ? ", " : "") + tones[i].name;
  figure.caption = fmt::format(
      "The {}, mode {}: harmonic least squares over windows of {:.3g} s ({:.0f} periods) every "
      "{:.2g} s, plotted at their midpoints{}; ribbons are 95 % intervals. A window cannot "
      "separate the mode from a neighbouring mode that beats with it, so the curve includes that "
      "beat.",
      shown_quantity(definition, compared_quantities(definition).front()).word, tones[0].name,
      sliding.length, periods_per_window, sliding.step,
      others.empty() ? "" : ", fitted together with " + others);
  figure.x_label = "midpoint of the window [s]";
  figure.x_range = {0, definition.duration};
  figure.spans = outside_window(definition);
  return figure;
}

}  // namespace

std::vector<Figure> sliding_figures(const CaseAssessment& assessment) {
  const CaseDefinition& definition = assessment.definition;
  const std::vector<ToneRequest> modes = fitted_modes(definition);
  if (modes.empty()) return {};
  const SlidingWindows sliding = windows_of(definition, modes.front());
  const std::vector<ToneRequest> tones = resolved_tones(modes, sliding.length);
  Figure ratio = frame(definition, tones, sliding), lag = ratio;
  ratio.id = case_id(definition.name) + "-sliding-amplitude";
  ratio.title = "Amplitude ratio over time";
  ratio.y_label = "amplitude over the reference's [1]";
  lag.id = case_id(definition.name) + "-sliding-lag";
  lag.title = "Phase lag over time";
  lag.y_label = "phase lag [deg] (positive: late)";
  for (const Comparison* pair : shown_comparisons(assessment)) {
    const auto fits = fits_of(assessment, *pair, sliding, tones);
    if (!fits) continue;
    ratio.curves.push_back(curve_of(definition, *pair, *fits, &ModeComparison::amplitude_error, 1));
    lag.curves.push_back(curve_of(definition, *pair, *fits, &ModeComparison::phase_lag_degrees, 0));
    add_band(definition, *pair, tones[0].name, Metric::amplitude_error, 1, ratio);
    add_band(definition, *pair, tones[0].name, Metric::phase_lag, 0, lag);
  }
  if (ratio.curves.empty()) return {};
  return {ratio, lag};
}

}  // namespace slosh

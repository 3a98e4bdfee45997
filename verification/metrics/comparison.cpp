#include "verification/metrics/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "verification/metrics/cross_correlation.hpp"
#include "verification/metrics/windowed_series.hpp"

namespace slosh {
namespace {

using std::numbers::pi;

// Integral of x y by the trapezoidal rule.
double integral(const std::vector<double>& time, const std::vector<double>& x,
                const std::vector<double>& y) {
  double sum = 0;
  for (std::size_t i = 1; i < time.size(); ++i) {
    sum += 0.5 * (time[i] - time[i - 1]) * (x[i] * y[i] + x[i - 1] * y[i - 1]);
  }
  return sum;
}

// x / y - 1 with the first-order interval of independent x and y.
Estimate relative_error(const Estimate& x, const Estimate& y) {
  const double ratio = x.value / y.value;
  return {.value = ratio - 1,
          .half_width = std::hypot(x.half_width, ratio * y.half_width) / std::abs(y.value)};
}

Estimate scaled(const Estimate& estimate, double factor) {
  return {.value = estimate.value * factor, .half_width = estimate.half_width * factor};
}

ModeComparison compare_tones(const Tone& candidate, const Tone& reference) {
  const Estimate lag_angle{
      .value = wrap_angle(reference.phase_at_middle.value - candidate.phase_at_middle.value),
      .half_width = std::min(pi, std::hypot(reference.phase_at_middle.half_width,
                                            candidate.phase_at_middle.half_width))};
  return {
      .mode = reference.name,
      .candidate = candidate,
      .reference = reference,
      .amplitude_error = relative_error(candidate.amplitude, reference.amplitude),
      .phase_lag = scaled(lag_angle, 1 / reference.angular_frequency.value),
      .phase_lag_degrees = scaled(lag_angle, 180 / pi),
      .phase_lag_periods = scaled(lag_angle, 1 / (2 * pi)),
      .frequency_error = relative_error(candidate.angular_frequency, reference.angular_frequency),
      .decay_rate = candidate.decay_rate,
      .decay_error = relative_error(candidate.decay_rate, reference.decay_rate)};
}

void compare_whole_window(const CommonSamples& common, Comparison& result) {
  const auto& [time, c, r] = common;
  const std::vector<double> one(time.size(), 1.0);
  const double mean = integral(time, r, one) / integral(time, one, one);
  std::vector<double> residual(time.size()), varying(time.size());
  for (std::size_t i = 0; i < time.size(); ++i) {
    residual[i] = c[i] - r[i];
    varying[i] = r[i] - mean;
    result.maximum_residual = std::max(result.maximum_residual, std::abs(residual[i]));
  }
  result.normalised_rms =
      std::sqrt(integral(time, residual, residual) / integral(time, varying, varying));
  const double cc = integral(time, c, c), rr = integral(time, r, r), rc = integral(time, r, c);
  result.sprague_geers_magnitude = std::sqrt(cc / rr) - 1;
  result.sprague_geers_phase = std::acos(std::clamp(rc / std::sqrt(rr * cc), -1.0, 1.0)) / pi;
  result.residual = {.name = result.quantity + " residual",
                     .unit = result.unit,
                     .time = time,
                     .value = std::move(residual)};
}

void compare_modes(const TimeSeries& candidate, const TimeSeries& reference,
                   const std::vector<ToneRequest>& modes, Comparison& result) {
  const TimeWindow window = result.window;
  const HarmonicFit fitted_candidate = fit_harmonics(candidate, window, modes);
  const HarmonicFit fitted_reference = fit_harmonics(reference, window, modes);
  for (std::size_t k = 0; k < modes.size(); ++k) {
    result.modes.push_back(compare_tones(fitted_candidate.tones[k], fitted_reference.tones[k]));
  }
  result.cross_correlation_lag =
      cross_correlation_lag(candidate, reference, window, 2 * pi / modes.front().angular_frequency);
  const int peaks = static_cast<int>(modes.size()) + 1;
  result.candidate_peaks = spectral_peaks(power_spectrum(candidate, window), peaks);
  result.reference_peaks = spectral_peaks(power_spectrum(reference, window), peaks);
}

TimeSeries named(const std::string& role, TimeSeries series) {
  series.name = role + " " + series.name;
  return series;
}

}  // namespace

Comparison compare(const TimeSeries& candidate_series, const TimeSeries& reference_series,
                   TimeWindow window, const std::vector<ToneRequest>& modes) {
  const TimeSeries candidate = named("candidate", candidate_series);
  const TimeSeries reference = named("reference", reference_series);
  if (candidate.unit != reference.unit) {
    throw ComparisonError(fmt::format("{} is in {}, {} in {}; expected the same unit",
                                      candidate.name, candidate.unit, reference.name,
                                      reference.unit));
  }
  const TimeSeries cut_reference = cut_to_window(reference, window);
  require_variation(cut_reference);
  require_variation(cut_to_window(candidate, window));

  Comparison result{};
  result.quantity = reference_series.name;
  result.unit = reference.unit;
  result.window = window;
  compare_whole_window(common_samples(candidate, cut_reference), result);
  constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
  if (modes.empty()) {
    result.cross_correlation_lag = no_number;
    result.alignment = align_in_time(candidate, cut_reference);
  } else {
    result.alignment = {no_number, no_number};
    compare_modes(candidate, reference, modes, result);
  }
  return result;
}

}  // namespace slosh

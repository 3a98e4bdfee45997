#include "verification/fits/harmonic_fit.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "verification/fits/window_fit.hpp"
#include "verification/series/windowed_series.hpp"

namespace slosh {
namespace {

using std::numbers::pi;

// sqrt(13.28), the 99 % point of chi-square with the four parameters of a refined tone. In noise
// alone, the amplitude that the search finds stays below this many standard errors.
constexpr double detection_level = 3.644, normal_quantile = 1.959964;

// Whether the search ended at an end of its range: the optimum may lie outside.
bool at_edge(double value, double low, double high) {
  // The map to the range is a sine, flat at its ends: the search surely comes this close.
  const double edge = 1e-3 * (high - low);
  return !(value > low + edge && value < high - edge);
}

bool detected(const Estimate& amplitude) {
  return amplitude.value > detection_level / normal_quantile * amplitude.half_width;
}

bool at_edge(const ToneShape& shape, const ToneRange& range) {
  const auto& [low, high] = range;
  return at_edge(shape.decay_rate, low.decay_rate, high.decay_rate) ||
         at_edge(shape.angular_frequency, low.angular_frequency, high.angular_frequency);
}

void widen(Tone& tone, const ToneRange& range) {
  const auto& [low, high] = range;
  tone.amplitude.half_width = std::max(tone.amplitude.half_width, tone.amplitude.value);
  tone.angular_frequency.half_width = high.angular_frequency - low.angular_frequency;
  tone.decay_rate.half_width = high.decay_rate - low.decay_rate;
  tone.phase.half_width = tone.phase_at_middle.half_width = pi;
}

// An unnamed tone that the window cannot tell from the requested one must not correct it: the
// estimate stays that of the fit.
ResidualModel correcting(const ResidualModel& model, const std::optional<double>& beside) {
  return beside ? model.without_corrections() : model;
}

Tone tone_of(const WindowFit& fit, std::size_t k, const ResidualModel& model) {
  const auto beside = fit.beside(k, model);
  const WindowFit::ToneEstimates found = fit.estimates(k, correcting(model, beside));
  Tone tone{.name = fit.requests[k].name,
            .resolved = detected(found.amplitude),
            .angular_frequency = found.angular_frequency,
            .decay_rate = found.decay_rate,
            .amplitude = found.amplitude,
            .phase = found.phase,
            .phase_at_middle = found.phase_at_middle,
            .beside = beside};
  if (fit.requests[k].refine && at_edge(fit.shapes[k], fit.ranges[k])) tone.resolved = false;
  if (tone.beside || (fit.requests[k].refine && !tone.resolved)) widen(tone, fit.ranges[k]);
  return tone;
}

// The fit's first two coefficients belong to the columns 1 and 2 s / span - 1.
HarmonicFit harmonic_fit(const WindowFit& fit, const TimeSeries& cut) {
  const Eigen::VectorXd residual = fit.residual(cut.time, cut.value);
  const ResidualModel model = fit.residual_model(cut.time, residual);
  HarmonicFit found{
      .mean = fit.coefficients[0],
      .trend = 2 * fit.coefficients[1] / (fit.window.end - fit.window.begin),
      .tones = {},
      .residual_rms = std::sqrt(residual.squaredNorm() / static_cast<double>(residual.size()))};
  for (std::size_t k = 0; k < fit.requests.size(); ++k)
    found.tones.push_back(tone_of(fit, k, model));
  return found;
}

// As a share of the tone's amplitude. Of an unnamed tone half a spectral bin off, the fit leaves
// three quarters in the residual: where two residuals differ by less than this share, the unnamed
// tones differ by little more.
constexpr double alike_share = 0.01;

// The candidate's residual less the reference's, the latter scaled by the ratio of the amplitudes.
struct ResidualDifference {
  Eigen::VectorXd values;
  double share;            // rms of the values over the candidate's amplitude
  double reference_share;  // rms of the reference's residual over the reference's amplitude
};

ResidualDifference residual_difference(const WindowFit& candidate, const WindowFit& reference,
                                       std::size_t k, const CommonSamples& common) {
  const auto amplitude = [k](const WindowFit& fit) {
    return fit.coefficients.segment<2>(static_cast<Eigen::Index>(2 + 2 * k)).norm();
  };
  const double ratio = amplitude(candidate) / amplitude(reference);
  const auto rms = [](const Eigen::VectorXd& of) {
    return std::sqrt(of.squaredNorm() / static_cast<double>(of.size()));
  };
  const Eigen::VectorXd of_reference = reference.residual(common.time, common.reference);
  Eigen::VectorXd values = candidate.residual(common.time, common.candidate) - ratio * of_reference;
  const double share = rms(values) / amplitude(candidate);
  return {std::move(values), share, rms(of_reference) / amplitude(reference)};
}

bool both_distinct(const Tone& candidate, const Tone& reference) {
  return !candidate.beside && !reference.beside;
}

bool can_be_paired(const Tone& candidate, const Tone& reference,
                   const ResidualDifference& difference) {
  return candidate.resolved && reference.resolved &&
         (both_distinct(candidate, reference) || difference.share < alike_share);
}

// The difference of two tones whose errors are independent.
PairedDifference unpaired(const Tone& candidate, const Tone& reference) {
  const auto difference = [](const Estimate& c, const Estimate& r) -> Estimate {
    return {c.value - r.value, std::hypot(c.half_width, r.half_width)};
  };
  const double ratio = candidate.amplitude.value / reference.amplitude.value;
  Estimate phase = difference(candidate.phase_at_middle, reference.phase_at_middle);
  phase = {wrap_angle(phase.value), std::min(pi, phase.half_width)};
  return {.amplitude_ratio = {ratio, std::hypot(candidate.amplitude.half_width,
                                                ratio * reference.amplitude.half_width) /
                                         reference.amplitude.value},
          .phase_at_middle = phase,
          .angular_frequency = difference(candidate.angular_frequency, reference.angular_frequency),
          .decay_rate = difference(candidate.decay_rate, reference.decay_rate),
          .beside = candidate.beside ? candidate.beside : reference.beside};
}

PairedDifference paired(const WindowFit& candidate, const WindowFit& reference, std::size_t k,
                        const ResidualModel& model) {
  const auto beside = candidate.beside(k, model);
  const auto of_c = candidate.estimates(k, correcting(model, beside));
  const auto of_r = reference.estimates(k, model.without_corrections());
  const auto difference = [](const Estimate& c, const Estimate& r) -> Estimate {
    return {c.value - r.value, c.half_width};
  };
  Estimate phase = difference(of_c.phase_at_middle, of_r.phase_at_middle);
  phase.value = wrap_angle(phase.value);
  return {.amplitude_ratio = {of_c.amplitude.value / of_r.amplitude.value,
                              of_c.amplitude.half_width / of_r.amplitude.value},
          .phase_at_middle = phase,
          .angular_frequency = difference(of_c.angular_frequency, of_r.angular_frequency),
          .decay_rate = difference(of_c.decay_rate, of_r.decay_rate),
          .beside = beside};
}

// Both series may hold the same unnamed tone, of complex amplitude U, that the window cannot tell
// from the named one, T. The fits then give T + k U, and the ratio is 1 + d T / (T + k U) in place
// of 1 + d. Its error is d k U / T to first order. For an unnamed tone 0.35, 0.4 and 0.5 of a bin
// off, |k U| is 2.0, 1.6 and 1.2 times the rms that it leaves in the residual. Twice the rms of the
// reference's residual therefore bounds the error down to 0.35 of a bin: there 89 to 95 % of the
// intervals were counted to hold the truth. At half a bin the bound is wide: 98 to 99 % do.
PairedDifference widened_by_unnamed(PairedDifference difference, double reference_share) {
  const double rest = 2 * reference_share;
  const auto widen = [](Estimate& estimate, double by) {
    estimate.half_width = std::hypot(estimate.half_width, by);
  };
  const double ratio = difference.amplitude_ratio.value;
  const double change = std::abs(std::polar(ratio, difference.phase_at_middle.value) - 1.0);
  widen(difference.amplitude_ratio, rest * change);
  widen(difference.phase_at_middle, rest * change / ratio);
  difference.phase_at_middle.half_width = std::min(pi, difference.phase_at_middle.half_width);
  widen(difference.angular_frequency, rest * std::abs(difference.angular_frequency.value));
  widen(difference.decay_rate, rest * std::abs(difference.decay_rate.value));
  return difference;
}

}  // namespace

HarmonicFit fit_harmonics(const TimeSeries& series, TimeWindow window,
                          const std::vector<ToneRequest>& requests) {
  return SeriesFit(series, window, requests).harmonics();
}

SeriesFit::SeriesFit(TimeSeries series, TimeWindow window, const std::vector<ToneRequest>& requests)
    : series_(std::move(series)) {
  const TimeSeries cut = cut_to_window(series_, window);
  fit_ = std::make_shared<const WindowFit>(fit_window(cut, window, requests));
  harmonics_ = harmonic_fit(*fit_, cut);
}

PairedDifference paired_difference(const SeriesFit& candidate, const SeriesFit& reference,
                                   std::size_t k) {
  const CommonSamples common =
      common_samples(candidate.series(), cut_to_window(reference.series(), reference.fit().window));
  const Tone &of_c = candidate.harmonics().tones[k], &of_r = reference.harmonics().tones[k];
  const ResidualDifference residuals =
      residual_difference(candidate.fit(), reference.fit(), k, common);
  PairedDifference apart = unpaired(of_c, of_r);
  if (!can_be_paired(of_c, of_r, residuals)) return apart;
  const PairedDifference difference =
      paired(candidate.fit(), reference.fit(), k,
             candidate.fit().residual_model(common.time, residuals.values, k));
  if (!difference.beside)
    return both_distinct(of_c, of_r) ? difference
                                     : widened_by_unnamed(difference, residuals.reference_share);
  apart.beside = difference.beside;
  return apart;
}

}  // namespace slosh

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
HarmonicFit harmonic_fit(const WindowFit& fit, const Eigen::VectorXd& residual,
                         const ResidualModel& model) {
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

// The residuals of both fits at the same times, and the candidate's less the reference's, the
// latter scaled by the ratio of the amplitudes.
struct ResidualDifference {
  Eigen::VectorXd candidate, reference, values;
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
  const Eigen::VectorXd of_candidate = candidate.residual(common.time, common.candidate),
                        of_reference = reference.residual(common.time, common.reference),
                        values = of_candidate - ratio * of_reference;
  return {of_candidate, of_reference, values, rms(values) / amplitude(candidate),
          rms(of_reference) / amplitude(reference)};
}

bool both_distinct(const Tone& candidate, const Tone& reference) {
  return !candidate.beside && !reference.beside;
}

bool can_be_paired(const Tone& candidate, const Tone& reference,
                   const ResidualDifference& difference) {
  return candidate.resolved && reference.resolved &&
         (both_distinct(candidate, reference) || difference.share < alike_share);
}

// The values of the difference, of tones or of their estimates; the half widths are zero.
template <class Parameters>
PairedDifference difference_of(const Parameters& candidate, const Parameters& reference) {
  const auto less = [](const Estimate& c, const Estimate& r) -> Estimate {
    return {c.value - r.value, 0};
  };
  PairedDifference found{
      .amplitude_ratio = {candidate.amplitude.value / reference.amplitude.value, 0},
      .phase_at_middle = less(candidate.phase_at_middle, reference.phase_at_middle),
      .angular_frequency = less(candidate.angular_frequency, reference.angular_frequency),
      .decay_rate = less(candidate.decay_rate, reference.decay_rate)};
  found.phase_at_middle.value = wrap_angle(found.phase_at_middle.value);
  return found;
}

// The half widths for errors of the candidate and independent ones of the reference that have these
// half widths.
template <class Parameters>
void widen_independently(PairedDifference& difference, const Parameters& candidate,
                         const Parameters& reference) {
  const auto widen = [](Estimate& of, const Estimate& c, const Estimate& r, double by_r) {
    of.half_width = std::hypot(c.half_width, by_r * r.half_width);
  };
  const double ratio = difference.amplitude_ratio.value;
  widen(difference.amplitude_ratio, candidate.amplitude, reference.amplitude, ratio);
  difference.amplitude_ratio.half_width /= reference.amplitude.value;
  widen(difference.phase_at_middle, candidate.phase_at_middle, reference.phase_at_middle, 1);
  widen(difference.angular_frequency, candidate.angular_frequency, reference.angular_frequency, 1);
  widen(difference.decay_rate, candidate.decay_rate, reference.decay_rate, 1);
}

// Narrows the half widths of independent errors by what the residuals share. With Z the complex
// ratio, at the angle p, and e the errors that noise gives the two complex amplitudes, the error of
// the ratio is e_c - Z e_r. Its variance is cos p of that of e_c - |Z| e_r, which the difference of
// the residuals shows, and 1 - cos p of that of independent errors, which `difference` has.
template <class Parameters>
void narrow_by_shared(PairedDifference& difference, const Parameters& together,
                      const Parameters& reference) {
  const double share = std::cos(difference.phase_at_middle.value);
  const auto narrow = [share](Estimate& of, double half_width) {
    of.half_width = std::sqrt(std::max(
        0.0, share * half_width * half_width + (1 - share) * of.half_width * of.half_width));
  };
  narrow(difference.amplitude_ratio, together.amplitude.half_width / reference.amplitude.value);
  narrow(difference.phase_at_middle, together.phase_at_middle.half_width);
  narrow(difference.angular_frequency, together.angular_frequency.half_width);
  narrow(difference.decay_rate, together.decay_rate.half_width);
}

// Adds to the half widths how far the values of `other` are.
void widen_to(PairedDifference& difference, const PairedDifference& other) {
  const auto widen = [](Estimate& of, double apart) { of.half_width += std::abs(apart); };
  widen(difference.amplitude_ratio, difference.amplitude_ratio.value - other.amplitude_ratio.value);
  widen(difference.phase_at_middle,
        wrap_angle(difference.phase_at_middle.value - other.phase_at_middle.value));
  widen(difference.angular_frequency,
        difference.angular_frequency.value - other.angular_frequency.value);
  widen(difference.decay_rate, difference.decay_rate.value - other.decay_rate.value);
}

void limit_phase(PairedDifference& difference) {
  difference.phase_at_middle.half_width = std::min(pi, difference.phase_at_middle.half_width);
}

// The difference of two tones whose errors are independent.
PairedDifference unpaired(const Tone& candidate, const Tone& reference) {
  PairedDifference difference = difference_of(candidate, reference);
  widen_independently(difference, candidate, reference);
  limit_phase(difference);
  difference.beside = candidate.beside ? candidate.beside : reference.beside;
  return difference;
}

PairedDifference paired(const SeriesFit& candidate, const SeriesFit& reference, std::size_t k,
                        const CommonSamples& common, const ResidualDifference& residuals) {
  const WindowFit &of_c = candidate.fit(), &of_r = reference.fit();
  const Tone &tone_c = candidate.harmonics().tones[k], &tone_r = reference.harmonics().tones[k];
  std::vector<ToneShape> known;
  if (both_distinct(tone_c, tone_r))
    known = of_either(candidate.model().further, reference.model().further, of_c.shapes[k],
                      of_c.window.end - of_c.window.begin);
  const ResidualModel model =
      model_residual(of_c.at_times(common.time, residuals.values), k, known);
  const ResidualModel noise = model.without_corrections();
  const auto corrected_alike = [&](const WindowFit& fit, const Eigen::VectorXd& residual) {
    ResidualModel alike = noise;
    alike.correction = correction_by(fit.at_times(common.time, residual), model.further);
    return fit.estimates(k, alike);
  };
  const auto own_c = of_c.estimates(k, candidate.model().without_corrections()),
             own_r = of_r.estimates(k, reference.model().without_corrections());
  PairedDifference difference = difference_of(tone_c, tone_r);
  widen_independently(difference, own_c, own_r);
  narrow_by_shared(difference, of_c.estimates(k, noise), own_r);
  widen_to(difference, difference_of(corrected_alike(of_c, residuals.candidate),
                                     corrected_alike(of_r, residuals.reference)));
  if (candidate.model().beside[k] || reference.model().beside[k])
    widen_to(difference, difference_of(own_c, own_r));
  limit_phase(difference);
  difference.beside = of_c.beside(k, model);
  return difference;
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
  limit_phase(difference);
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
  const Eigen::VectorXd residual = fit_->residual(cut.time, cut.value);
  model_ =
      std::make_shared<const ResidualModel>(model_residual(fit_->at_times(cut.time, residual)));
  harmonics_ = harmonic_fit(*fit_, residual, *model_);
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
  const PairedDifference difference = paired(candidate, reference, k, common, residuals);
  if (!difference.beside)
    return both_distinct(of_c, of_r) ? difference
                                     : widened_by_unnamed(difference, residuals.reference_share);
  apart.beside = difference.beside;
  return apart;
}

}  // namespace slosh

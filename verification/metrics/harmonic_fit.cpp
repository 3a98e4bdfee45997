#include "verification/metrics/harmonic_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "verification/metrics/window_fit.hpp"
#include "verification/metrics/windowed_series.hpp"

namespace slosh {
namespace {

using std::numbers::pi;

// sqrt(13.28), the 99 % point of chi-square with the four parameters of a refined tone: what the
// search finds in noise alone stays below this many standard errors.
constexpr double detection_level = 3.644, normal_quantile = 1.959964;

// Whether the search ended at an end of its range, so that the data would have it outside.
bool at_edge(double value, double low, double high) {
  const double edge =
      1e-3 * (high - low);  // as near as the sine's flat ends let it come for certain
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

// What the window cannot tell from the tone corrects nothing of it: the estimate stays the fit's.
LeftoverModel correcting(const LeftoverModel& leftovers, const std::optional<double>& beside) {
  return beside ? leftovers.without_corrections() : leftovers;
}

Tone tone_of(const WindowFit& fit, std::size_t k, const LeftoverModel& leftovers) {
  const auto beside = fit.beside(k, leftovers);
  const WindowFit::ToneEstimates found = fit.estimates(k, correcting(leftovers, beside));
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

// c0 and c1 are those of 1 and 2 s / span - 1.
HarmonicFit harmonic_fit(const WindowFit& fit, const TimeSeries& cut) {
  const Eigen::VectorXd residual = fit.residual(cut.time, cut.value);
  const LeftoverModel leftovers = fit.leftovers(cut.time, residual);
  HarmonicFit found{
      .mean = fit.coefficients[0],
      .trend = 2 * fit.coefficients[1] / (fit.window.end - fit.window.begin),
      .tones = {},
      .residual_rms = std::sqrt(residual.squaredNorm() / static_cast<double>(residual.size()))};
  for (std::size_t k = 0; k < fit.requests.size(); ++k)
    found.tones.push_back(tone_of(fit, k, leftovers));
  return found;
}

// Tone by tone.
std::vector<PairedDifference> differences(const WindowFit& candidate, const WindowFit& reference,
                                          const CommonSamples& common) {
  const Eigen::VectorXd of_candidate = candidate.residual(common.time, common.candidate),
                        of_reference = reference.residual(common.time, common.reference);
  std::vector<PairedDifference> found;
  for (std::size_t k = 0; k < candidate.requests.size(); ++k) {
    const auto amplitude = [k](const WindowFit& fit) {
      return fit.coefficients.segment<2>(static_cast<Eigen::Index>(2 + 2 * k)).norm();
    };
    const double ratio = amplitude(candidate) / amplitude(reference);
    const LeftoverModel leftovers =
        candidate.leftovers(common.time, of_candidate - ratio * of_reference);
    const auto beside = candidate.beside(k, leftovers);
    const auto of_c = candidate.estimates(k, correcting(leftovers, beside));
    const auto of_r = reference.estimates(k, leftovers.without_corrections());
    const auto difference = [](const Estimate& c, const Estimate& r) -> Estimate {
      return {c.value - r.value, c.half_width};
    };
    Estimate phase = difference(of_c.phase_at_middle, of_r.phase_at_middle);
    phase.value = wrap_angle(phase.value);
    found.push_back(
        {.amplitude_ratio = {of_c.amplitude.value / of_r.amplitude.value,
                             of_c.amplitude.half_width / of_r.amplitude.value},
         .phase_at_middle = phase,
         .angular_frequency = difference(of_c.angular_frequency, of_r.angular_frequency),
         .decay_rate = difference(of_c.decay_rate, of_r.decay_rate),
         .beside = beside});
  }
  return found;
}

}  // namespace

void require_resolved(TimeWindow window, const std::vector<ToneRequest>& requests) {
  const double length = window.end - window.begin;
  const auto require_apart = [&](double difference, const std::string& which) {
    const double needed = 2 * pi / std::abs(difference);
    if (!(length > needed)) {
      throw ComparisonError(
          fmt::format("the window of {:.4g} s cannot resolve {}; needed: more than {:.4g} s",
                      length, which, needed));
    }
  };
  const auto describe = [](const ToneRequest& tone) {
    return fmt::format("{} ({:.4g} Hz)", tone.name, tone.angular_frequency / (2 * pi));
  };
  for (std::size_t i = 0; i < requests.size(); ++i) {
    if (!(requests[i].angular_frequency > 0)) {
      throw ComparisonError(describe(requests[i]) + ": expected a positive frequency");
    }
    require_apart(requests[i].angular_frequency, describe(requests[i]) + " from the mean");
    for (std::size_t j = 0; j < i; ++j) {
      require_apart(requests[i].angular_frequency - requests[j].angular_frequency,
                    describe(requests[j]) + " from " + describe(requests[i]));
    }
  }
}

double wrap_angle(double angle) { return std::remainder(angle, 2 * pi); }

HarmonicFit fit_harmonics(const TimeSeries& series, TimeWindow window,
                          const std::vector<ToneRequest>& requests) {
  const TimeSeries cut = cut_to_window(series, window);
  return harmonic_fit(fit_window(cut, window, requests), cut);
}

PairedFit fit_pair(const TimeSeries& candidate, const TimeSeries& reference, TimeWindow window,
                   const std::vector<ToneRequest>& requests) {
  const TimeSeries cut_candidate = cut_to_window(candidate, window),
                   cut_reference = cut_to_window(reference, window);
  const WindowFit fitted_candidate = fit_window(cut_candidate, window, requests),
                  fitted_reference = fit_window(cut_reference, window, requests);
  const CommonSamples common = common_samples(candidate, cut_reference);
  return {harmonic_fit(fitted_candidate, cut_candidate),
          harmonic_fit(fitted_reference, cut_reference),
          differences(fitted_candidate, fitted_reference, common)};
}

}  // namespace slosh

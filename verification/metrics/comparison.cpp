#include "verification/metrics/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include "verification/fits/block_jackknife.hpp"
#include "verification/series/sample_moments.hpp"
#include "verification/series/time_series.hpp"
#include "verification/series/windowed_series.hpp"

namespace slosh {
namespace {

using std::numbers::pi;

TimeSeries named(const std::string& role, TimeSeries series) {
  series.name = role + " " + series.name;
  return series;
}

double mean_of(const std::vector<double>& time, const std::vector<double>& value) {
  double sum = 0;
  for (std::size_t i = 1; i < time.size(); ++i)
    sum += 0.5 * (time[i] - time[i - 1]) * (value[i] + value[i - 1]);
  return sum / (time.back() - time.front());
}

Estimate scaled(const Estimate& estimate, double factor) {
  return {.value = estimate.value * factor, .half_width = estimate.half_width * factor};
}

ModeComparison compare_tones(const Tone& candidate, const Tone& reference,
                             const PairedDifference& difference) {
  ModeComparison mode{};
  mode.mode = reference.name;
  mode.candidate = candidate;
  mode.reference = reference;
  mode.beside = difference.beside;
  const Estimate lag_angle{-difference.phase_at_middle.value,
                           std::min(pi, difference.phase_at_middle.half_width)};
  mode.amplitude_error = {difference.amplitude_ratio.value - 1,
                          difference.amplitude_ratio.half_width};
  mode.phase_lag = scaled(lag_angle, 1 / reference.angular_frequency.value);
  mode.phase_lag_degrees = scaled(lag_angle, 180 / pi);
  mode.phase_lag_periods = scaled(lag_angle, 1 / (2 * pi));
  mode.frequency_error =
      scaled(difference.angular_frequency, 1 / reference.angular_frequency.value);
  mode.decay_rate = candidate.decay_rate;
  mode.decay_error = scaled(difference.decay_rate, 1 / reference.decay_rate.value);
  return mode;
}

std::vector<ModeComparison> compare_fits(const SeriesFit& candidate, const SeriesFit& reference,
                                         const std::set<std::string>& asked) {
  const std::vector<Tone>& tones = reference.harmonics().tones;
  std::vector<ModeComparison> compared;
  for (std::size_t k = 0; k < tones.size(); ++k)
    if (asked.empty() || asked.contains(tones[k].name))
      compared.push_back(compare_tones(candidate.harmonics().tones[k], tones[k],
                                       paired_difference(candidate, reference, k)));
  return compared;
}

// The integrals over the interval before the i-th sample, by the trapezoidal rule.
BlockIntegrals over_interval(const CommonSamples& common, double mean, std::size_t i) {
  const auto at = [&](std::size_t k) {
    const double c = common.candidate[k], r = common.reference[k];
    return BlockIntegrals{(c - r) * (c - r), (r - mean) * (r - mean), c * c, r * r, c * r};
  };
  BlockIntegrals ends = at(i - 1);
  ends += at(i);
  const double half = 0.5 * (common.time[i] - common.time[i - 1]);
  return {half * ends.residual, half * ends.variation, half * ends.candidate, half * ends.reference,
          half * ends.product};
}

std::vector<BlockIntegrals> block_integrals(const CommonSamples& common, int count) {
  const double mean = mean_of(common.time, common.reference);
  const std::size_t intervals = common.time.size() - 1;
  std::vector<BlockIntegrals> blocks(static_cast<std::size_t>(count));
  for (std::size_t i = 1; i <= intervals; ++i)
    blocks[(i - 1) * blocks.size() / intervals] += over_interval(common, mean, i);
  return blocks;
}

void compare_whole_window(const CommonSamples& common, int blocks, Comparison& result) {
  const std::vector<BlockIntegrals> sums = block_integrals(common, blocks);
  result.normalised_rms = block_jackknife(
      sums, [](const BlockIntegrals& of) { return std::sqrt(of.residual / of.variation); });
  result.sprague_geers_magnitude = block_jackknife(
      sums, [](const BlockIntegrals& of) { return std::sqrt(of.candidate / of.reference) - 1; });
  result.sprague_geers_phase = block_jackknife(sums, [](const BlockIntegrals& of) {
    return std::acos(std::clamp(of.product / std::sqrt(of.reference * of.candidate), -1.0, 1.0)) /
           pi;
  });
  std::vector<double> residual(common.time.size());
  for (std::size_t i = 0; i < residual.size(); ++i) {
    residual[i] = common.candidate[i] - common.reference[i];
    result.maximum_residual = std::max(result.maximum_residual, std::abs(residual[i]));
  }
  result.residual = {.name = result.quantity + " residual",
                     .unit = result.unit,
                     .time = common.time,
                     .value = std::move(residual)};
}

// The number of blocks, from the period of the slowest mode; 1 without modes.
int blocks_of(TimeWindow window, const std::vector<ToneRequest>& modes) {
  if (modes.empty()) return 1;
  double slowest = modes.front().angular_frequency;
  for (const ToneRequest& mode : modes) slowest = std::min(slowest, mode.angular_frequency);
  return block_count(window.end - window.begin, 2 * pi / slowest);
}

void add_modes(const PreparedSeries& candidate, const PreparedSeries& reference,
               const std::set<std::string>& asked, Comparison& result) {
  const std::vector<ToneRequest>& modes = reference.modes;
  if (candidate.fit && reference.fit)
    result.modes = compare_fits(*candidate.fit, *reference.fit, asked);
  result.cross_correlation_lag = cross_correlation_lag(
      candidate.series, reference.series, result.window, 2 * pi / modes.front().angular_frequency);
  result.cross_correlation_lag_degrees =
      result.cross_correlation_lag * modes.front().angular_frequency * 180 / pi;
  const int peaks = static_cast<int>(modes.size()) + 1;
  result.candidate_peaks = spectral_peaks(*candidate.spectrum, peaks);
  result.reference_peaks = spectral_peaks(*reference.spectrum, peaks);
}

// A value at which one alone stays is no rest: what falls dry in the one comes near to it in the
// other.
SensorReadings resting_with(const PreparedSeries& one, const PreparedSeries& other) {
  constexpr double near = 0.25;  // of the other's range
  const auto ends = std::ranges::minmax(other.cut.value);
  const double reach = near * (ends.max - ends.min);
  SensorReadings readings = one.readings;
  std::erase_if(readings.rests,
                [&](double rest) { return rest < ends.min - reach || rest > ends.max + reach; });
  return readings;
}

// An error relative to a reference that does not move beside the candidate is no figure.
void require_swing(const Comparison& of) {
  constexpr double least = 1e-9;  // of the candidate's deviation
  const double swing = of.reference_wave.deviation, other = of.candidate_wave.deviation;
  if (swing < least * other)
    throw ComparisonError(fmt::format(
        "the reference's {} deviates from its mean by {:.2g} {}, the candidate's by {:.2g} {}; "
        "expected a billionth of that at least",
        of.quantity, swing, of.unit, other, of.unit));
}

}  // namespace

PreparedSeries::PreparedSeries(const std::string& role, TimeSeries of, TimeWindow over,
                               std::vector<ToneRequest> requests, Detail detail)
    : quantity(of.name),
      series(named(role, std::move(of))),
      window(over),
      modes(std::move(requests)),
      cut(cut_to_window(series, window)),
      constant(is_constant(cut)),
      readings{role, series.unit, sensor_limits(series, window),
               series.unit == "Pa" ? std::vector<double>{0} : std::vector<double>{}},
      covered(covered_share(series, window)) {
  if (modes.empty() || constant) return;
  require_resolved(window, modes);
  require_sampled(cut, modes);
  if (detail == Detail::fitted_tones) fit.emplace(series, window, modes);
  spectrum = power_spectrum(series, window);
}

void PreparedSeries::add_band(const QuantileBand& around) {
  band = {cut_to_window(around.lower, window), cut_to_window(around.upper, window)};
}

std::vector<ModeComparison> compare_modes(const TimeSeries& candidate, const TimeSeries& reference,
                                          TimeWindow window,
                                          const std::vector<ToneRequest>& modes) {
  return compare_fits({candidate, window, modes}, {reference, window, modes}, {});
}

Comparison compare(const PreparedSeries& candidate, const PreparedSeries& reference,
                   const std::set<std::string>& asked) {
  const std::vector<ToneRequest>& modes = reference.modes;
  Comparison result{};
  result.quantity = reference.quantity;
  result.unit = reference.series.unit;
  result.window = reference.window;
  if (candidate.series.unit != result.unit)
    throw ComparisonError(fmt::format("{} is in {}, {} in {}; expected the same unit",
                                      candidate.series.name, candidate.series.unit,
                                      reference.series.name, result.unit));
  result.reference_is_constant = reference.constant;
  if (!reference.constant) require_variation(candidate.cut);
  const CommonSamples all = common_samples(candidate.series, reference.cut);
  result.unseen = unseen_interval(candidate.series, all);
  result.covered = std::min(candidate.covered, reference.covered);
  if (!reference.constant) {
    for (const PreparedSeries* one : {&reference, &candidate}) {
      const PreparedSeries& other = one == &reference ? candidate : reference;
      std::ranges::move(doubts_of_readings(resting_with(*one, other)),
                        std::back_inserter(result.doubts));
      if (one->readings.limits.step) result.in_steps.push_back(one->readings);
    }
  }
  const CommonSamples common = outside_gaps(candidate.series, all);
  if (common.time.size() < 2)
    throw ComparisonError(
        fmt::format("{}: {} of the {} samples of {} lie outside of its gaps; expected at least 2",
                    candidate.series.name, common.time.size(), reference.cut.time.size(),
                    reference.series.name));
  compare_whole_window(outside_gaps(candidate.series, samples_of_both(candidate.series, all)),
                       blocks_of(result.window, modes), result);
  result.candidate_wave = wave_statistics(common.time, common.candidate);
  result.reference_wave = wave_statistics(common.time, common.reference);
  if (!reference.constant) require_swing(result);
  for (const double value : without_mean(common.reference))
    result.largest_departure = std::max(result.largest_departure, std::abs(value));
  if (reference.band) {
    result.margin = band_margin(common.time, common.candidate, *reference.band);
    result.margin_of_nothing =
        band_margin(common.time, std::vector<double>(common.time.size()), *reference.band);
  }
  result.cross_correlation_lag = result.cross_correlation_lag_degrees = not_a_number;
  result.alignment = {not_a_number, not_a_number};
  if (reference.constant) {
    result.normalised_rms = {not_a_number, not_a_number};
    return result;
  }
  if (modes.empty())
    result.alignment = align_in_time(candidate.series, reference.cut);
  else
    add_modes(candidate, reference, asked, result);
  return result;
}

Comparison compare(const TimeSeries& candidate, const TimeSeries& reference, TimeWindow window,
                   const std::vector<ToneRequest>& modes) {
  return compare(PreparedSeries("candidate", candidate, window, modes),
                 PreparedSeries("reference", reference, window, modes));
}

double normalised_rms_without_offset(const Comparison& comparison) {
  const TimeSeries& residual = comparison.residual;
  const auto mean_square_about = [&](double datum) {
    std::vector<double> squares;
    for (const double one : residual.value) squares.push_back((one - datum) * (one - datum));
    return mean_of(residual.time, squares);
  };
  const double all = mean_square_about(0);
  if (all == 0) return 0;
  const double mean = mean_of(residual.time, residual.value);
  return comparison.normalised_rms.value * std::sqrt(mean_square_about(mean) / all);
}

}  // namespace slosh

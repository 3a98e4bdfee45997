#include "verification/sensitivity/gate_claims.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "verification/case/metric_table.hpp"
#include "verification/fits/harmonic_fit.hpp"
#include "verification/series/sample_moments.hpp"
#include "verification/series/windowed_series.hpp"

namespace slosh {
namespace {

constexpr double counted_part = 0.9;  // of a shift, a stretch, a noise or a largest value
constexpr double rounding = 1e-9;     // relative: a value on its bound claims nothing
constexpr double half_turn = 180, whole_turn = 360;  // [deg]

// What the metric becomes, or what it then reaches at least.
struct Prediction {
  double value;
  bool at_least = false;
};

std::optional<double> factor_of(const Mutation& mutation) {
  switch (mutation.kind) {
    case MutationKind::louder:
      return 1 + mutation.strength;
    case MutationKind::quieter:
      return 1 - mutation.strength;
    case MutationKind::thousandfold:
      return 1000;
    case MutationKind::sign_flipped:
      return -1;
    default:
      return std::nullopt;
  }
}

// Counted part of what is gained by the first kind and lost by the second.
std::optional<double> change_of(const Mutation& mutation, MutationKind up, MutationKind down) {
  if (mutation.kind == up) return counted_part * mutation.strength;
  if (mutation.kind == down) return -counted_part * mutation.strength;
  return std::nullopt;
}

double wrap_degrees(double angle) {
  return wrap_angle(angle * std::numbers::pi / half_turn) * half_turn / std::numbers::pi;
}

// What sets the mutant apart from the candidate in the window.
std::vector<double> change_in_window(const TimeSeries& candidate, const TimeSeries& mutant,
                                     TimeWindow window) {
  return minus(cut_to_window(mutant, window).value, cut_to_window(candidate, window).value);
}

double deviation_in_window(const TimeSeries& series, TimeWindow window) {
  return rms(without_mean(cut_to_window(series, window).value));
}

// Counted part: the metric looks at the reference's times alone.
double largest_in_window(const TimeSeries& series, TimeWindow window) {
  double largest = 0;
  for (const double value : cut_to_window(series, window).value)
    largest = std::max(largest, std::abs(value));
  return counted_part * largest;
}

std::optional<Prediction> of_scale(const GateRow& row, const JudgedCandidate& candidate,
                                   double factor, TimeWindow window) {
  const double e = candidate.measured;
  switch (row.metric) {
    case Metric::amplitude_error:
    case Metric::rms_error:
      return Prediction{(1 + e) * std::abs(factor) - 1};
    case Metric::band_energy_error:
      return Prediction{(1 + e) * factor * factor - 1};
    case Metric::crest_error:
    case Metric::trough_error:  // a flipped sign makes troughs of crests
      if (factor > 0) return Prediction{(1 + e) * factor - 1};
      return std::nullopt;
    case Metric::largest_magnitude:
      return Prediction{std::abs(factor) * e};
    case Metric::initial_value:
      return Prediction{factor * e};
    case Metric::normalised_rms:
      return Prediction{std::abs(factor - 1) * (1 - e) - e, true};
    case Metric::maximum_residual:
      return Prediction{std::abs(factor - 1) * largest_in_window(candidate.series, window) - e,
                        true};
    case Metric::phase_lag:
      if (factor < 0) return Prediction{wrap_degrees(e + half_turn)};
      return std::nullopt;
    default:
      return std::nullopt;
  }
}

std::optional<Prediction> of_shift(const GateRow& row, double e, double periods, double period) {
  if (row.metric == Metric::phase_lag || row.metric == Metric::cross_correlation_lag)
    return Prediction{wrap_degrees(e + whole_turn * periods)};
  if (row.metric == Metric::time_lag) return Prediction{e + periods * period};
  return std::nullopt;
}

std::optional<Prediction> of_offset(const GateRow& row, double e, double offset) {
  if (row.metric == Metric::mean_offset || row.metric == Metric::initial_value)
    return Prediction{e + offset};
  if (row.metric == Metric::largest_magnitude) return Prediction{std::abs(offset) - e, true};
  return std::nullopt;
}

// By the triangle inequality, of what adds something to the candidate.
std::optional<Prediction> of_residual(const GateRow& row, const JudgedCandidate& candidate,
                                      const Mutation& mutation, const MutationFrame& frame) {
  const bool is_rms = row.metric == Metric::normalised_rms;
  if (!is_rms && row.metric != Metric::maximum_residual) return std::nullopt;
  const double e = candidate.measured;
  const std::vector<double> change =
      change_in_window(candidate.series, mutated(candidate.series, mutation, frame), frame.window);
  if (is_rms)
    return Prediction{
        counted_part * rms(change) / deviation_in_window(candidate.series, frame.window) * (1 - e) -
            e,
        true};
  double largest = 0;
  for (const double one : change) largest = std::max(largest, std::abs(one));
  return Prediction{counted_part * largest - e, true};
}

// Of the kinds that add something: a datum, a ramp, a part of a mode, a slow change of frequency.
std::optional<Prediction> of_addition(const GateRow& row, const JudgedCandidate& candidate,
                                      const Mutation& mutation, const MutationFrame& frame) {
  const double e = candidate.measured, s = mutation.strength;
  switch (mutation.kind) {
    case MutationKind::raised:
    case MutationKind::lowered:
      if (const auto found =
              of_offset(row, e, (mutation.kind == MutationKind::raised ? s : -s) * frame.datum))
        return found;
      break;
    case MutationKind::drifting:
      if (row.metric == Metric::mean_offset)
        return Prediction{e + counted_part * s / 2 *
                                  deviation_in_window(candidate.series, frame.window)};
      break;
    case MutationKind::chirped:
      if (row.metric == Metric::phase_lag && row.mode == "forced")
        return Prediction{wrap_degrees(e - counted_part * s / 3 * whole_turn)};
      break;
    case MutationKind::mode_gained:
      if (row.metric == Metric::amplitude_error && row.mode == mutation.mode)
        return Prediction{(1 + e) * (1 + counted_part * s) - 1};
      break;
    case MutationKind::mode_damped:
      if (row.metric == Metric::decay_rate && row.mode == mutation.mode && e > 0)
        return Prediction{e * (1 + counted_part * s)};
      break;
    default:
      return std::nullopt;
  }
  return of_residual(row, candidate, mutation, frame);
}

std::optional<Prediction> after(const GateRow& row, const JudgedCandidate& candidate,
                                const Mutation& mutation, const MutationFrame& frame) {
  const double e = candidate.measured;
  if (const auto factor = factor_of(mutation))
    return of_scale(row, candidate, *factor, frame.window);
  if (const auto periods = change_of(mutation, MutationKind::late, MutationKind::early))
    return of_shift(row, e, *periods, frame.period);
  if (const auto gain = change_of(mutation, MutationKind::faster, MutationKind::slower);
      gain && ((row.metric == Metric::frequency_error && row.mode != "forced") ||
               row.metric == Metric::spectral_peak_error))
    return Prediction{(1 + e) * (1 + *gain) - 1};
  if (mutation.kind == MutationKind::noisy && row.metric == Metric::noise_share)
    return Prediction{counted_part * mutation.strength / std::hypot(1, mutation.strength), true};
  if (mutation.kind == MutationKind::noisy && row.metric == Metric::normalised_rms)
    return Prediction{counted_part * mutation.strength * (1 - e) - e, true};
  return of_addition(row, candidate, mutation, frame);
}

bool outside_bounds(const GateRow& row, const Prediction& prediction) {
  if (!row.limit && !row.between) return false;
  const auto [lower, upper] = row.limit ? std::pair{-*row.limit, *row.limit} : *row.between;
  const double slack = rounding * std::max(std::abs(lower), std::abs(upper));
  return prediction.value > upper + slack ||
         (!prediction.at_least && prediction.value < lower - slack);
}

}  // namespace

bool claims_to_detect(const GateRow& row, const JudgedCandidate& candidate,
                      const Mutation& mutation, const MutationFrame& frame) {
  if (is_of_impacts(row.metric)) return false;
  if (mutation.kind == MutationKind::other_unit && row.metric == Metric::noise_share) return false;
  if (!changes_values(mutation.kind)) return true;
  const auto prediction = after(row, candidate, mutation, frame);
  return prediction && outside_bounds(row, *prediction);
}

}  // namespace slosh

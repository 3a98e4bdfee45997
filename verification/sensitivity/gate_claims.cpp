#include "verification/sensitivity/gate_claims.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "verification/case/metric_table.hpp"
#include "verification/case/motion.hpp"
#include "verification/fits/harmonic_fit.hpp"
#include "verification/series/sample_moments.hpp"
#include "verification/series/windowed_series.hpp"

namespace slosh {
namespace {

constexpr double counted_part = 0.9;  // of a shift, a stretch or a noise
constexpr double rounding = 1e-9;     // relative; a value on its bound claims nothing
constexpr double half_turn = 180, whole_turn = 360;  // [deg]

// The metric of the mutated candidate, or its lower bound.
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

// The counted part of the strength: positive for the first kind, negative for the second.
std::optional<double> change_of(const Mutation& mutation, MutationKind up, MutationKind down) {
  if (mutation.kind == up) return counted_part * mutation.strength;
  if (mutation.kind == down) return -counted_part * mutation.strength;
  return std::nullopt;
}

double wrap_degrees(double angle) {
  return wrap_angle(angle * std::numbers::pi / half_turn) * half_turn / std::numbers::pi;
}

// The mutant less the candidate, in the window.
std::vector<double> change_in_window(const TimeSeries& candidate, const TimeSeries& mutant,
                                     TimeWindow window) {
  return minus(cut_to_window(mutant, window).value, cut_to_window(candidate, window).value);
}

double deviation_in_window(const TimeSeries& series, TimeWindow window) {
  return rms(without_mean(cut_to_window(series, window).value));
}

MutationResponse response_of(const GateRow& row) { return metric_entry(row.metric).response; }

std::optional<Prediction> of_scale(const GateRow& row, double e, double factor) {
  switch (response_of(row)) {
    case MutationResponse::as_amplitude:
      return Prediction{(1 + e) * std::abs(factor) - 1};
    case MutationResponse::as_magnitude:
      return Prediction{std::abs(factor) * e};
    case MutationResponse::as_start:
      return Prediction{factor * e};
    case MutationResponse::as_rms_residual:
      return Prediction{std::abs(factor - 1) * (1 - e) - e, true};
    case MutationResponse::as_phase:
      if (factor < 0) return Prediction{wrap_degrees(e + half_turn)};
      break;
    case MutationResponse::as_mean:
    case MutationResponse::as_correlation:
    case MutationResponse::as_frequency:
    case MutationResponse::as_decay:
    case MutationResponse::as_noise:
    case MutationResponse::as_field_rms:
    case MutationResponse::unpredicted:
      break;
  }
  return std::nullopt;
}

std::optional<Prediction> of_shift(const GateRow& row, double e, double periods) {
  const MutationResponse response = response_of(row);
  if (response == MutationResponse::as_phase || response == MutationResponse::as_correlation)
    return Prediction{wrap_degrees(e + whole_turn * periods)};
  return std::nullopt;
}

std::optional<Prediction> of_offset(const GateRow& row, double e, double offset) {
  const MutationResponse response = response_of(row);
  if (response == MutationResponse::as_mean || response == MutationResponse::as_start)
    return Prediction{e + offset};
  if (response == MutationResponse::as_magnitude) return Prediction{std::abs(offset) - e, true};
  return std::nullopt;
}

// The lower bound of a residual after something was added to the candidate, by the triangle
// inequality.
std::optional<Prediction> of_residual(const GateRow& row, const JudgedCandidate& candidate,
                                      const Mutation& mutation, const MutationFrame& frame) {
  if (response_of(row) != MutationResponse::as_rms_residual) return std::nullopt;
  const double e = candidate.measured;
  const std::vector<double> change =
      change_in_window(candidate.series, mutated(candidate.series, mutation, frame), frame.window);
  return Prediction{
      counted_part * rms(change) / deviation_in_window(candidate.series, frame.window) * (1 - e) -
          e,
      true};
}

// The prediction for kinds that add something: an offset, a ramp, a part of a mode, a slow change
// of frequency.
std::optional<Prediction> of_addition(const GateRow& row, const JudgedCandidate& candidate,
                                      const Mutation& mutation, const MutationFrame& frame) {
  const double e = candidate.measured, s = mutation.strength;
  const MutationResponse response = response_of(row);
  switch (mutation.kind) {
    case MutationKind::raised:
    case MutationKind::lowered:
      if (const auto found =
              of_offset(row, e, (mutation.kind == MutationKind::raised ? s : -s) * frame.datum))
        return found;
      break;
    case MutationKind::drifting:
      if (response == MutationResponse::as_mean)
        return Prediction{e + counted_part * s / 2 *
                                  deviation_in_window(candidate.series, frame.window)};
      break;
    case MutationKind::chirped:
      if (response == MutationResponse::as_phase && is_forced(row.mode))
        return Prediction{wrap_degrees(e - counted_part * s / 3 * whole_turn)};
      break;
    case MutationKind::mode_gained:
      if (response == MutationResponse::as_amplitude && row.mode == mutation.mode)
        return Prediction{(1 + e) * (1 + counted_part * s) - 1};
      break;
    case MutationKind::mode_damped:
      if (response == MutationResponse::as_decay && row.mode == mutation.mode && e > 0)
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
  const MutationResponse response = response_of(row);
  if (const auto factor = factor_of(mutation)) return of_scale(row, e, *factor);
  if (const auto periods = change_of(mutation, MutationKind::late, MutationKind::early))
    return of_shift(row, e, *periods);
  if (const auto gain = change_of(mutation, MutationKind::faster, MutationKind::slower);
      gain && response == MutationResponse::as_frequency && !is_forced(row.mode))
    return Prediction{(1 + e) * (1 + *gain) - 1};
  if (mutation.kind == MutationKind::noisy && response == MutationResponse::as_noise)
    return Prediction{counted_part * mutation.strength / std::hypot(1, mutation.strength), true};
  if (mutation.kind == MutationKind::noisy && response == MutationResponse::as_rms_residual)
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
  if (mutation.kind == MutationKind::other_unit && response_of(row) == MutationResponse::as_noise)
    return false;
  if (!changes_values(mutation.kind)) return true;
  const auto prediction = after(row, candidate, mutation, frame);
  return prediction && outside_bounds(row, *prediction);
}

}  // namespace slosh

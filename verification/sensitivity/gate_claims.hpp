// The mutations of its candidate that a gate row must detect, derived from the metric's
// MutationResponse (metric_table.hpp), the row's bounds and the value E that it measures of the
// candidate as it is. With f the factor of a mutation that scales, s the strength of a mutation,
// and o an offset, the metric of the mutated candidate is
//   as_amplitude         (1 + E) |f| - 1; (1 + E) (1 + s) - 1 where the row's mode is amplified
//   as_magnitude         |f| E; at least |o| - E
//   as_start             f E; E + o
//   as_mean              E + o; E + s d / 2 of a drift to s deviations d
//   as_phase             E plus the shift, plus half a turn of a flipped sign; for the forced mode
//                        less a third of a turn times a chirp's s (the mean of u^2)
//   as_correlation       E plus the shift in degrees of the period
//   as_frequency         (1 + E) (1 + s) - 1 of a stretch of time, except for the forced mode
//   as_decay             E (1 + s) where the row's mode is damped
//   as_rms_residual      at least |f - 1| (1 - E) - E; s (1 - E) - E of noise; and rms(x) / rms(c -
//                        mean c) (1 - E) - E where a series x is added to the candidate c (an
//                        offset, a drift, a mode, a chirp)
//   as_noise             at least s / sqrt(1 + s^2) of noise
//   as_field_rms         see field_trials.hpp
// The lower bounds of residuals follow from the triangle inequality. The row claims the mutation
// where this value lies outside its bounds. Of a shift, a stretch, a noise and an added series nine
// tenths count: the rest is lost at the ends of the window, where values are held, and
// between samples. Every row on a series over the window claims NaN in the window, a series that
// ends in it, swapped columns and another unit, which as_noise does not depend on. All other pairs
// of metric and mutation claim nothing, nor do metrics of impacts; rows that compare two errors
// (improves_on) claim no change of values.
#pragma once

#include "verification/case/case_definition.hpp"
#include "verification/metrics/series_mutation.hpp"

namespace slosh {

// The candidate as it is, and the row's metric of it in the row's unit.
struct JudgedCandidate {
  double measured;
  const TimeSeries& series;
};

// Throws ComparisonError as cut_to_window() does for the candidate.
bool claims_to_detect(const GateRow& row, const JudgedCandidate& candidate,
                      const Mutation& mutation, const MutationFrame& frame);

}  // namespace slosh

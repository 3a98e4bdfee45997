// Which mutations of its candidate a gate row must detect, told from its metric, its bounds and the
// value E that it measures of the candidate as it is. With f the factor of a mutation that scales:
//   amplitude_error    becomes (1 + E) f - 1, as rms_error, crest_error and trough_error
//   band_energy_error  becomes (1 + E) f^2 - 1
//   noise_share        is at least s / sqrt(1 + s^2) of noise of strength s
//   largest_magnitude  becomes |f| E
//   normalised_rms     is at least |f - 1| (1 - E) - E, and s (1 - E) - E of noise of strength s
//   maximum_residual   is at least |f - 1| max |candidate| - E
//   initial_value      becomes f E, and E + o of an offset o
//   mean_offset        becomes E + o of an offset o, and E + s d / 2 of a drift to s deviations d
//   largest_magnitude  is at least |o| - E
// Of what adds a series x to the candidate c (an offset, a drift, a gained mode, a chirp):
//   normalised_rms     is at least rms(x) / rms(c - mean c) (1 - E) - E
//   maximum_residual   is at least max |x| - E
// by the triangle inequality. phase_lag, cross_correlation_lag, time_lag and frequency_error move
// by the shift or stretch, the phase by half a turn of a flipped sign, and that of the forced mode
// by a third of a turn times a chirp's strength (the mean of u^2); the amplitude error of a gained
// mode becomes (1 + E) (1 + s) - 1. The row claims the mutation where that lies outside its bounds.
// Of a shift, a stretch, a noise, an added series and max |candidate| nine tenths are counted, as
// the ends of the window, filled with held values, and the times between samples take their part.
// NaN in the window, a series that ends in it, swapped columns and another unit are claimed by
// every row that looks at a series over the window (another unit not by noise_share, which is a
// share of the series itself). What a metric is blind to (a phase to the amplitude, every mode to a
// slip by whole periods), rows that compare two errors (improves_on) and the metrics of impacts
// claim nothing more.
#pragma once

#include "verification/case/case_definition.hpp"
#include "verification/metrics/series_mutation.hpp"

namespace slosh {

// The row's metric of its candidate as it is, in the row's unit, and that candidate.
struct JudgedCandidate {
  double measured;
  const TimeSeries& series;
};

// Throws ComparisonError as cut_to_window() does of the candidate.
bool claims_to_detect(const GateRow& row, const JudgedCandidate& candidate,
                      const Mutation& mutation, const MutationFrame& frame);

}  // namespace slosh

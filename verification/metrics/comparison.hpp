// What sets a candidate's time series apart from a reference's: per fitted mode the amplitude
// error, the phase lag and the frequency error, each with its confidence interval; over the whole
// window the normalised residuals, the lag by cross-correlation and Sprague and Geers' magnitude
// and phase; and the spectral peaks of both. With I_xy the integral of x y over the window, c the
// candidate, r the reference:
//   amplitude error = A_c / A_r - 1,   lag = wrap(phi_r - phi_c) / w, phases at the window's middle
//   M = sqrt(I_cc / I_rr) - 1,   P = acos(I_rc / sqrt(I_rr I_cc)) / pi
// (Sprague & Geers 2004 after Schwer 2007; P has no sign). Errors and
// lags of modes, and their intervals, are of the difference of the two: fit_pair() of
// harmonic_fit.hpp.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "verification/fits/harmonic_fit.hpp"
#include "verification/metrics/prepared_series.hpp"
#include "verification/metrics/time_alignment.hpp"
#include "verification/series/spectrum.hpp"
#include "verification/series/time_series.hpp"
#include "verification/series/wave_statistics.hpp"

namespace slosh {

struct ModeComparison {
  std::string mode;  // "forced", "natural_1", ...
  Tone candidate, reference;
  // [rad/s], of what the window cannot tell from the difference of the two.
  std::optional<double> beside = {};
  bool resolved() const { return candidate.resolved && reference.resolved && !beside; }
  Estimate amplitude_error;  // A_c / A_r - 1
  Estimate phase_lag;        // [s], positive when the candidate is late; wrapped to half a period
  Estimate phase_lag_degrees;
  Estimate phase_lag_periods;
  Estimate frequency_error;  // omega_c / omega_r - 1 (zero for the forced mode, whose frequency is
                             // given)
  Estimate decay_rate;       // of the candidate [1/s]
  Estimate decay_error;      // g_c / g_r - 1; means something where the reference decays
};

struct Comparison {
  std::string candidate, reference;  // names of the runs, for the caller to fill in
  std::string quantity, unit;        // the reference's
  TimeWindow window;
  std::vector<ModeComparison> modes;  // those that were asked for; empty of spectra alone
  // Of each mode's energies within a fifth of its frequency to either side (spectrum.hpp):
  // E_c / E_r - 1; NaN where the window cannot resolve that band.
  std::map<std::string, double> band_energy_error;
  // Of the whole window; intervals by block_jackknife.hpp, none without modes.
  Estimate normalised_rms;  // rms(c - r) / rms(r - mean r)
  double maximum_residual;  // max |c - r|, in the quantity's unit
  // [s], positive when late; within half a period of the first mode, NaN without modes.
  double cross_correlation_lag;
  double cross_correlation_lag_degrees;  // of that period
  TimeAlignment alignment;               // NaN with modes, whose lags say it better
  Estimate sprague_geers_magnitude, sprague_geers_phase;
  // Of both at the reference's times inside the window, by the first mode's period.
  WaveStatistics candidate_wave, reference_wave;
  TimeSeries residual;  // c - r at the reference's times inside the window
  // One more than modes, highest first; none without modes.
  std::vector<SpectralPeak> candidate_peaks, reference_peaks;
};

// The modes alone, in their order, of two series in one unit. Throws as fit_harmonics() does.
std::vector<ModeComparison> compare_modes(const TimeSeries& candidate, const TimeSeries& reference,
                                          TimeWindow window, const std::vector<ToneRequest>& modes);

// Compares two series over their window. The candidate is interpolated (cubic) to the reference's
// times. Throws ComparisonError when the units differ. Without modes the whole histories alone are
// compared, and of spectra alone all but the modes. `asked` names the modes that are compared; all
// where it is empty.
Comparison compare(const PreparedSeries& candidate, const PreparedSeries& reference,
                   const std::set<std::string>& asked = {});

// The same of two series that are prepared for it alone; throws as PreparedSeries does.
Comparison compare(const TimeSeries& candidate, const TimeSeries& reference, TimeWindow window,
                   const std::vector<ToneRequest>& modes);

}  // namespace slosh

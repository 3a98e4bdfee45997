// The difference of a candidate's time series from a reference's. Each fitted mode gives the
// amplitude error, the phase lag and the frequency error with their confidence intervals. The whole
// window gives the normalised residuals, the lag by cross-correlation, Sprague and Geers' magnitude
// and phase, and the spectral peaks of both. With I_xy the integral of x y over the window, c the
// candidate, r the reference:
//   amplitude error = A_c / A_r - 1,   lag = wrap(phi_r - phi_c) / w, phases at the window's middle
//   M = sqrt(I_cc / I_rr) - 1,   P = acos(I_rc / sqrt(I_rr I_cc)) / pi
// (Sprague & Geers 2004 after Schwer 2007; P has no sign). The errors and lags of modes, and their
// intervals, are those of paired_difference() in harmonic_fit.hpp.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "verification/fits/harmonic_fit.hpp"
#include "verification/metrics/quantile_band.hpp"
#include "verification/metrics/reading_doubts.hpp"
#include "verification/metrics/time_alignment.hpp"
#include "verification/metrics/unseen_interval.hpp"
#include "verification/series/spectrum.hpp"
#include "verification/series/time_series.hpp"
#include "verification/series/wave_statistics.hpp"

namespace slosh {

// How the modes are analysed: fitted, or by the spectrum alone, which takes a hundredth of the
// time.
enum class Detail { fitted_tones, spectrum_alone };

// One series over one window, with all that a comparison needs of this series alone. It is computed
// once, however many other series are compared with it.
struct PreparedSeries {
  // Messages name the series by its role ("candidate elevation@left"). Throws ComparisonError when
  // it holds a non-finite value, falls short of the window by more than one sample or is too sparse
  // for the modes, or when the window cannot resolve these.
  PreparedSeries(const std::string& role, TimeSeries series, TimeWindow window,
                 std::vector<ToneRequest> modes, Detail detail = Detail::fitted_tones);

  // Adds the band of a reference, whose edges are checked and cut as the series is. Throws
  // ComparisonError as cut_to_window() does.
  void add_band(const QuantileBand& around);

  std::string quantity;
  TimeSeries series;  // named by its role and quantity
  TimeWindow window;
  std::vector<ToneRequest> modes;
  TimeSeries cut;                    // to the window
  bool constant;                     // to rounding: it then has no modes
  SensorReadings readings;           // of the cut
  double covered;                    // of the window (unseen_interval.hpp)
  std::optional<SeriesFit> fit;      // nullopt without modes and for Detail::spectrum_alone
  std::optional<Spectrum> spectrum;  // nullopt without modes
  std::optional<QuantileBand> band;  // cut to the window
};

struct ModeComparison {
  std::string mode;  // "forced", "natural_1", ...
  Tone candidate, reference;
  // Frequency [rad/s] of an unnamed tone that the window cannot tell from the difference of the
  // two.
  std::optional<double> beside = {};
  bool resolved() const { return candidate.resolved && reference.resolved && !beside; }
  Estimate amplitude_error;  // A_c / A_r - 1
  Estimate phase_lag;        // [s], positive when the candidate is late; wrapped to half a period
  Estimate phase_lag_degrees;
  Estimate phase_lag_periods;
  Estimate frequency_error;  // omega_c / omega_r - 1 (zero for the forced mode, whose frequency is
                             // given)
  Estimate decay_rate;       // of the candidate [1/s]
  Estimate decay_error;      // g_c / g_r - 1; only meaningful where the reference decays
};

struct Comparison {
  std::string candidate, reference;  // names of the runs, filled in by the caller
  std::string quantity, unit;        // the reference's
  TimeWindow window;
  // The reference is constant over the window: only the means and the residual can be compared, and
  // all that divides by the reference's variation or by its modes is NaN or empty.
  bool reference_is_constant = false;
  std::optional<UnseenInterval> unseen;  // what the samples do not tell
  double covered = 1;                    // the share of the asked window that both cover
  std::vector<std::string> doubts;       // about the readings of both (reading_doubts.hpp)
  std::vector<SensorReadings> in_steps;  // those of both that have a step
  std::vector<ModeComparison> modes;     // the modes asked for; empty for Detail::spectrum_alone
  // Over the whole window; intervals by block_jackknife.hpp, unknown without modes.
  Estimate normalised_rms;  // rms(c - r) / rms(r - mean r)
  double maximum_residual;  // max |c - r|, in the quantity's unit
  // [s], positive when late; within half a period of the first mode, NaN without modes.
  double cross_correlation_lag;
  double cross_correlation_lag_degrees;  // of that period
  TimeAlignment alignment;               // NaN with modes, which have lags of their own
  Estimate sprague_geers_magnitude, sprague_geers_phase;
  // Of both at the reference's times inside the window.
  WaveStatistics candidate_wave, reference_wave;
  TimeSeries residual;  // c - r inside the window, at the times of samples_of_both()
  // The candidate's margin in the reference's band (quantile_band.hpp), and that of a candidate of
  // zeros; nullopt without a band.
  std::optional<TimeSeries> margin, margin_of_nothing;
  double largest_departure = 0;  // of the reference from its mean, in the quantity's unit
  // One more than there are modes, highest first; empty without modes.
  std::vector<SpectralPeak> candidate_peaks, reference_peaks;
};

// Returns the normalised rms that is left without the mean of the residual: what the difference
// would be if the two had the same datum.
double normalised_rms_without_offset(const Comparison& comparison);

// Compares only the modes, in their order, of two series in one unit. Throws as fit_harmonics()
// does.
std::vector<ModeComparison> compare_modes(const TimeSeries& candidate, const TimeSeries& reference,
                                          TimeWindow window, const std::vector<ToneRequest>& modes);

// Compares two series over their window. The residual is taken at the times of both where the
// reference resolves its signal (samples_of_both()), all else at the reference's times; between its
// samples a series is interpolated (cubic). The whole window leaves out the candidate's gaps
// (outside_gaps()). Without modes, only the whole time series are compared;
// with Detail::spectrum_alone, everything except the modes. `asked` names the modes to compare;
// empty means all of them. Throws ComparisonError when the units differ and when the candidate
// alone is constant, and where the candidate's gaps leave fewer than two samples.
Comparison compare(const PreparedSeries& candidate, const PreparedSeries& reference,
                   const std::set<std::string>& asked = {});

// Prepares two series and compares them. Throws as PreparedSeries does.
Comparison compare(const TimeSeries& candidate, const TimeSeries& reference, TimeWindow window,
                   const std::vector<ToneRequest>& modes);

}  // namespace slosh

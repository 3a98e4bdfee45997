// Harmonic least squares over a window:
//   y = c0 + c1 t + sum_k exp(-g_k (t - t0)) (a_k cos w_k t + b_k sin w_k t),
// where t0 is the window's begin. This is the primary metric of the harness. It fits the forcing
// and the natural modes together, because one tone fitted to a beating signal gets both amplitude
// and lag wrong (a lag of 0.100 T comes out as 0.063 T). The deterministic part of the residual is
// modelled (residual_model.hpp) and gives first-order corrections to the estimates; the noise about
// each tone (local_noise.hpp) gives their intervals. Valid where the window resolves the tones from
// one another and from its mean: length > 1 / |f1 - f2| and > 1 / f.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "verification/fits/tone_request.hpp"
#include "verification/series/time_series.hpp"

namespace slosh {

// A fitted tone. It is not resolved where it cannot be distinguished from noise (the interval of
// its amplitude, with 3.64 in place of 1.96 standard errors, reaches zero), or where the search for
// a refined tone ended at an end of its range. For a refined tone that is not resolved, the
// interval of the amplitude reaches down to zero, and the half widths of frequency, decay rate and
// phase are the whole range that was searched (phase: pi).
struct Tone {
  std::string name;
  bool resolved;
  Estimate angular_frequency;  // [rad/s], within 10 % of the request
  Estimate decay_rate;         // [1/s], amplitude ~ exp(-decay_rate t)
  Estimate amplitude;          // at t = window.begin, in the series' unit
  // [rad], y ~ amplitude cos(w t + phase), phase = atan2(-b, a), with the series' own t.
  Estimate phase;
  // [rad], w t + phase at the window's middle, wrapped to [-pi, pi]. It is free of the uncertainty
  // that a refined w adds to a phase at a distant t = 0.
  Estimate phase_at_middle;
  // Frequency [rad/s] of an unnamed tone that the window cannot tell from this one. Where there is
  // one, the half widths are those of a tone that is not resolved.
  std::optional<double> beside = {};
};

struct HarmonicFit {
  double mean;              // c0 at the window's middle
  double trend;             // c1 [unit/s]
  std::vector<Tone> tones;  // in the order of the requests
  double residual_rms;
};

// Throws ComparisonError as require_resolved(), cut_to_window() and require_sampled() do.
HarmonicFit fit_harmonics(const TimeSeries& series, TimeWindow window,
                          const std::vector<ToneRequest>& requests);

struct WindowFit;      // window_fit.hpp
struct ResidualModel;  // residual_model.hpp

// A series with its fit, for comparison with the fits of other series.
class SeriesFit {
 public:
  // Throws as fit_harmonics() does.
  SeriesFit(TimeSeries series, TimeWindow window, const std::vector<ToneRequest>& requests);

  const TimeSeries& series() const { return series_; }
  const HarmonicFit& harmonics() const { return harmonics_; }
  const WindowFit& fit() const { return *fit_; }
  const ResidualModel& model() const { return *model_; }

 private:
  TimeSeries series_;
  std::shared_ptr<const WindowFit> fit_;
  std::shared_ptr<const ResidualModel> model_;
  HarmonicFit harmonics_;
};

// The difference between a candidate's tone and a reference's: candidate less reference with 95 %
// intervals, and the ratio of the amplitudes. Where one of the two tones is not resolved, the
// intervals treat the two as independent.
struct PairedDifference {
  Estimate amplitude_ratio;
  Estimate phase_at_middle;    // [rad], wrapped to [-pi, pi]
  Estimate angular_frequency;  // [rad/s]
  Estimate decay_rate;         // [1/s]
  // Frequency [rad/s] of an unnamed tone, in one of the two series or in their difference, that
  // the window cannot tell from this one; the ratio then means nothing. Exception: where the
  // residuals of both series differ by less than a hundredth of the tone, the ratio stands, with an
  // interval that is widened by the possible effect of the unnamed tone.
  std::optional<double> beside = {};
};

// Compares the k-th tone of two fits of one window and the same requests. The values are those of
// the two tones as the fits give them. The noise comes from the difference of the two residuals,
// the reference's scaled by the ratio of the amplitudes, less the tones that no request names:
// noise that both series share does not widen the interval. Both tones are then corrected once more
// by the same further tones, those of either series and of the difference; the interval reaches
// that second estimate. Valid to first order, for tones that are close to each other.
PairedDifference paired_difference(const SeriesFit& candidate, const SeriesFit& reference,
                                   std::size_t k);

}  // namespace slosh

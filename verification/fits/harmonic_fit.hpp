// Harmonic least squares over a window:
//   y = c0 + c1 t + sum_k exp(-g_k (t - t0)) (a_k cos w_k t + b_k sin w_k t),
// t0 the window's begin. The primary metric of the harness: fit the forcing and the natural modes
// together, because one tone fitted to a beating signal mis-states both amplitude and lag (a lag of
// 0.100 T comes out as 0.063 T). What the requested tones leave is modelled as far as it is
// deterministic and its noise is measured about each tone: leftover_model.hpp and local_noise.hpp,
// whose first-order corrections the estimates hold and whose intervals they have. Valid where the
// window resolves the tones from one another and from its mean: length > 1 / |f1 - f2| and > 1 / f.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "verification/series/estimate.hpp"
#include "verification/series/time_series.hpp"

namespace slosh {

// A mode to be fitted. The forced mode's frequency is known and it does not decay; a natural mode's
// frequency and decay rate are refined from the data by nonlinear least squares.
struct ToneRequest {
  std::string name;
  double angular_frequency;  // [rad/s]
  bool refine;
};

// A tone that cannot be told from noise (the interval of its amplitude, at 3.64 in place of 1.96
// standard errors, reaches zero), or a refined one whose search ended at an end of its range, is no
// error but not resolved. A refined one's
// amplitude has an interval that then reaches down to zero, and its frequency, decay rate and phase
// have the whole range that was searched (phase: pi) as half width.
struct Tone {
  std::string name;
  bool resolved;
  Estimate angular_frequency;  // [rad/s], within 10 % of the request
  Estimate decay_rate;         // [1/s], amplitude ~ exp(-decay_rate t)
  Estimate amplitude;          // at t = window.begin, in the series' unit
  // [rad], y ~ amplitude cos(w t + phase), phase = atan2(-b, a), t as in the series.
  Estimate phase;
  // [rad], w t + phase at the window's middle, wrapped to [-pi, pi]: free of the uncertainty that a
  // refined w carries to a phase at a far t = 0.
  Estimate phase_at_middle;
  // [rad/s], of something that the window cannot tell from the tone, which no request names: the
  // half widths are then those of a tone that is not resolved.
  std::optional<double> beside = {};
};

struct HarmonicFit {
  double mean;              // c0 at the window's middle
  double trend;             // c1 [unit/s]
  std::vector<Tone> tones;  // in the order of the requests
  double residual_rms;
};

// Throws ComparisonError when the window cannot resolve the tones, naming its length and the one
// needed.
void require_resolved(TimeWindow window, const std::vector<ToneRequest>& requests);

// Throws ComparisonError when samples are too few for the tones or an interval between two of them
// exceeds a tenth of the shortest period. `cut` lies in the window (cut_to_window()).
void require_sampled(const TimeSeries& cut, const std::vector<ToneRequest>& requests);

// Throws ComparisonError as require_resolved(), cut_to_window() and require_sampled() do.
HarmonicFit fit_harmonics(const TimeSeries& series, TimeWindow window,
                          const std::vector<ToneRequest>& requests);

struct WindowFit;  // window_fit.hpp

// A series with its fit, to be set beside others'.
class SeriesFit {
 public:
  // Throws as fit_harmonics() does.
  SeriesFit(TimeSeries series, TimeWindow window, const std::vector<ToneRequest>& requests);

  const TimeSeries& series() const { return series_; }
  const HarmonicFit& harmonics() const { return harmonics_; }
  const WindowFit& fit() const { return *fit_; }

 private:
  TimeSeries series_;
  std::shared_ptr<const WindowFit> fit_;
  HarmonicFit harmonics_;
};

// What sets the candidate's tone apart from the reference's: 95 % intervals of the candidate's less
// the reference's, and the ratio of the amplitudes. Where one of the two tones is not resolved the
// intervals are those of two things that know nothing of one another.
struct PairedDifference {
  Estimate amplitude_ratio;
  Estimate phase_at_middle;    // [rad], wrapped to [-pi, pi]
  Estimate angular_frequency;  // [rad/s]
  Estimate decay_rate;         // [1/s]
  // [rad/s], of something in one of the two, or in their difference alone, that the window cannot
  // tell from the tone: the ratio of what is part of something else tells nothing. Where what is
  // left of both is alike to a hundredth of the tone it does, with an interval that is wider by
  // what the unnamed tone can do to it.
  std::optional<double> beside = {};
};

// Of the k-th tone of two fits of one window and the same requests. The intervals are from what the
// fits leave of the one less what they leave of the other, scaled by the ratio of the tone's
// amplitudes: what both show alike and neither fit takes (higher modes, harmonics, beats) makes
// neither difference uncertain, nor corrects it, as it may correct the tones themselves. To the
// first order, for tones that are near one another.
PairedDifference paired_difference(const SeriesFit& candidate, const SeriesFit& reference,
                                   std::size_t k);

// Angle [rad] brought to [-pi, pi] by whole turns.
double wrap_angle(double angle);

}  // namespace slosh

// One series fitted over a window by the model of harmonic_fit.hpp, with what is needed to say more
// of it than its tones. Private to the metrics.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "verification/fits/harmonic_fit.hpp"
#include "verification/fits/leftover_model.hpp"
#include "verification/fits/tone_search.hpp"

namespace slosh {

struct WindowFit {
  TimeWindow window;
  std::vector<ToneRequest> requests;
  std::vector<ToneRange> ranges;
  std::vector<ToneShape> shapes;
  Eigen::VectorXd coefficients;  // c0, c1, then a and b of each tone

  // At any times [s]: d model / d (c0, c1, a_0, b_0, ...), then (w, g) of each refined tone.
  Eigen::MatrixXd jacobian(const std::vector<double>& time) const;
  // Values less the model.
  Eigen::VectorXd residual(const std::vector<double>& time, const std::vector<double>& value) const;
  // What is left of values at these times, such as residual() gives, and what it says of the tones,
  // or of the k-th alone.
  LeftoverModel leftovers(const std::vector<double>& time, const Eigen::VectorXd& left,
                          std::optional<std::size_t> k = {}) const;

  // The k-th tone's parameters with the corrections that a model of the leftovers makes to them,
  // and their 95 % intervals.
  struct ToneEstimates {
    Estimate amplitude, angular_frequency, decay_rate, phase, phase_at_middle;
  };
  ToneEstimates estimates(std::size_t k, const LeftoverModel& leftovers) const;

  // What the window cannot tell from the k-th tone and what moves it too far [rad/s].
  std::optional<double> beside(std::size_t k, const LeftoverModel& leftovers) const;
};

// Throws as fit_harmonics() does. `cut` lies in the window.
WindowFit fit_window(const TimeSeries& cut, TimeWindow window,
                     const std::vector<ToneRequest>& requests);

}  // namespace slosh

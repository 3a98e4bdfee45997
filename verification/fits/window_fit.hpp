// The fit of one series over a window by the model of harmonic_fit.hpp, with all that the estimates
// and their intervals need. Private to verification/fits/.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "verification/fits/residual_model.hpp"
#include "verification/fits/tone_request.hpp"
#include "verification/fits/tone_search.hpp"

namespace slosh {

struct WindowFit {
  TimeWindow window;
  std::vector<ToneRequest> requests;
  std::vector<ToneRange> ranges;
  std::vector<ToneShape> shapes;
  Eigen::VectorXd coefficients;  // c0, c1, then a and b of each tone

  // The derivatives at any times [s]: d model / d (c0, c1, a_0, b_0, ...), then by (w, g) of each
  // refined tone; one column per parameter.
  Eigen::MatrixXd jacobian(const std::vector<double>& time) const;
  // Values less the model.
  Eigen::VectorXd residual(const std::vector<double>& time, const std::vector<double>& value) const;
  // A residual at these times, such as residual() gives, with what its model needs.
  FitResidual at_times(const std::vector<double>& time, Eigen::VectorXd residuals) const;

  // The k-th tone's parameters with the corrections by a model of the residual, and their 95 %
  // intervals.
  struct ToneEstimates {
    Estimate amplitude, angular_frequency, decay_rate, phase, phase_at_middle;
  };
  ToneEstimates estimates(std::size_t k, const ResidualModel& model) const;

  // Frequency [rad/s] of an unnamed tone that the window cannot tell from the k-th tone and that
  // shifts it by more than largest_shift; nullopt where there is none.
  std::optional<double> beside(std::size_t k, const ResidualModel& model) const;
};

// Throws as fit_harmonics() does. `cut` is cut to the window.
WindowFit fit_window(const TimeSeries& cut, TimeWindow window,
                     const std::vector<ToneRequest>& requests);

}  // namespace slosh

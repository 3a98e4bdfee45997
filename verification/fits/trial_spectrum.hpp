// A search for the best single tone over a wide band, all frequencies of a grid at once. With C the
// two columns exp(-g s) cos(w s) and exp(-g s) sin(w s) of a tone, B an orthonormal basis and r the
// part of the values orthogonal to B, the tone explains
//   (C^T r)^T (C^T C - (B^T C)^T B^T C)^-1 C^T r
// of the sum of squares. At equally spaced times, the products with the columns of all frequencies
// of a grid are the Fourier transforms of exp(-g s) r and exp(-g s) B.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "verification/fits/tone_search.hpp"

namespace slosh {

class TrialSpectrum {
 public:
  // Takes equally spaced times [s]. The tones tried have frequencies from low to high [rad/s], at
  // most `spacing` apart, each with every one of the decay rates [1/s]; only those that `admits`
  // accepts are tried.
  TrialSpectrum(const Eigen::VectorXd& elapsed, double low, double high, double spacing,
                const std::vector<double>& decay_rates,
                const std::function<bool(const ToneShape&)>& admits);

  // Whether no tone is admitted.
  bool empty() const;

  // The tone that explains most of the part of the values orthogonal to the basis. Requires that
  // there is one.
  ToneShape best(const Eigen::VectorXd& value, const Eigen::MatrixXd& basis) const;

 private:
  struct OneDecay {
    double decay_rate;
    Eigen::VectorXd envelope;          // exp(-g s)
    Eigen::VectorXcd squares;          // transform of exp(-2 g s)
    std::vector<Eigen::Index> places;  // indices of the admitted frequencies on the grid
  };
  Eigen::Index length_;  // of the transforms
  double step_;          // of the grid's frequencies [rad/s]
  std::vector<OneDecay> decays_;
};

}  // namespace slosh

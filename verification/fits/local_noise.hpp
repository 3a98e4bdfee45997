// The noise about a tone and the uncertainty that it gives the tone's parameters. The error of a
// fitted parameter is c^T e, with e the noise and c a weight that is as narrow in frequency as the
// window allows. Only the noise level about the tone's frequency matters: not the level elsewhere,
// and not an autocovariance, which a window of two periods does not determine. The level is the
// mean square of the residual's projections on K directions: the tone times cos(j pi s / span), j =
// 0 to 5, less their part in the range of the fit. The interval uses Student's quantile of K
// degrees of freedom (Mueller 2007, J. Econometrics 141:1331; Sun 2013, Econometrics J. 16:1; few
// directions rather than many: Lazarus, Lewis, Stock & Watson 2018, J. Bus. Econ. Stat. 36:541).
//
// Where the spectrum slopes within the band, the weight c sees another level than the directions,
// and each direction a different one. First-order autoregressive noises represent such slopes: for
// each of them the variance is scaled by c^T R c over the directions' mean, with Satterthwaite's
// degrees of freedom (1946, Biometrics Bull. 2:110). The half widths are averaged with the weights
// of the noises' restricted likelihoods (Patterson & Thompson 1971, Biometrika 58:545).
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "verification/fits/tone_search.hpp"

namespace slosh {

// A linear least-squares fit at equally spaced times, as the model of its noise needs it.
struct FittedSamples {
  Eigen::VectorXd elapsed;   // [s]
  Eigen::MatrixXd jacobian;  // one column per parameter
  Eigen::MatrixXd basis;     // orthonormal, spans the Jacobian's range
  Eigen::VectorXd residual;
};

// Orthonormal columns that span the undamped tone times cos(j pi s / span), j = 0 to half_band:
// half_band / 2 spectral bins to either side. `angular_frequency` in [rad/s], `span` in [s].
Eigen::MatrixXd band_about(const Eigen::VectorXd& elapsed, double angular_frequency, double span,
                           int half_band);

// L x with L^T L the inverse of R_ij = correlation^|i - j|, applied to each column.
Eigen::MatrixXd whitened(const Eigen::MatrixXd& columns, double correlation);

// First-order autoregressive noises that the residual may hold, weighted by their likelihood; the
// weights sum to one.
struct LikelyNoise {
  double correlation;  // from sample to sample; 0 is white
  double weight;
};
std::vector<LikelyNoise> likely_noises(const FittedSamples& fit);

// The covariance of the fit's parameters under each of these noises, for a variance of one.
struct ParameterNoise {
  ParameterNoise(const FittedSamples& fit, std::vector<LikelyNoise> noises);

  std::vector<LikelyNoise> noises;
  std::vector<Eigen::MatrixXd> covariances;  // one per noise
};

class LocalNoise {
 public:
  LocalNoise() = default;  // unknown
  // The noise about this frequency [rad/s].
  LocalNoise(const FittedSamples& fit, double angular_frequency, double span,
             const ParameterNoise& of_parameters);

  // Whether the fit leaves at least one direction in which the level can be measured.
  bool known() const { return level_ >= 0; }

  // Half width of the 95 % interval of a quantity whose derivatives by the first parameters are
  // `gradient`; infinite where the level is unknown.
  double half_width(const Eigen::VectorXd& gradient) const;

 private:
  struct Shape {
    double weighted_quantile;
    Eigen::MatrixXd covariance;  // of the parameters, for a mean level of one
  };
  double level_ = -1;  // rms of the projections
  std::vector<Shape> shapes_;
};

// A search for the best single tone over a wide band, all frequencies of a grid at once. With C the
// two columns exp(-g s) cos(w s) and exp(-g s) sin(w s) of a tone, B an orthonormal basis and r the
// part of the values orthogonal to B, the tone explains
//   (C^T r)^T (C^T C - (B^T C)^T B^T C)^-1 C^T r
// of the sum of squares. At equally spaced times, the products with the columns of all frequencies
// of a grid are the Fourier transforms of exp(-g s) r and exp(-g s) B.

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

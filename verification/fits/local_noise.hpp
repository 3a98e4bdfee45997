// The noise about a tone and what it makes uncertain. The error of a fitted parameter is c^T e,
// with e the noise and c a weight that is as narrow in frequency as the window allows: the noise's
// level about the tone's frequency counts, and neither the level elsewhere nor an autocovariance,
// of which a window of two periods tells nothing. The level is the mean square of the residual's
// projections on K directions: the tone times cos(j pi s / span), j = 0 to 5, less what the fit
// takes of them. The interval has Student's quantile of K degrees of freedom (Mueller 2007, J.
// Econometrics 141:1331; Sun 2013, Econometrics J. 16:1; few directions rather than many: Lazarus,
// Lewis, Stock & Watson 2018, J. Bus. Econ. Stat. 36:541). A spectrum that slopes within the band
// gives the weight another level than the directions, and the directions different ones.
// First-order autoregressive noises stand for it: for each of them the variance is scaled by c^T R
// c over the directions' mean, with Satterthwaite's degrees of freedom (1946, Biometrics Bull.
// 2:110); the half widths are averaged with the weights of the noises' restricted likelihoods
// (Patterson & Thompson 1971, Biometrika 58:545).
#pragma once

#include <Eigen/Core>
#include <vector>

#include "verification/fits/tone_search.hpp"

namespace slosh {

// A linear least-squares fit at equally spaced times, as its noise is looked at.
struct FittedSamples {
  Eigen::VectorXd elapsed;   // [s]
  Eigen::MatrixXd jacobian;  // of the parameters
  Eigen::MatrixXd basis;     // orthonormal, of the Jacobian's range
  Eigen::VectorXd residual;
};

// Orthonormal columns that span the tone, undamped, times cos(j pi s / span), j = 0 to half_band:
// j / 2 spectral bins to either side.
Eigen::MatrixXd band_about(const Eigen::VectorXd& elapsed, double angular_frequency, double span,
                           int half_band);

// L x with L^T L the inverse of R_ij = correlation^|i - j|.
Eigen::MatrixXd whitened(const Eigen::MatrixXd& columns, double correlation);

// First-order autoregressive noises that the residual may hold, by their likelihood; the weights
// sum to one.
struct LikelyNoise {
  double correlation;  // from sample to sample; 0 is white
  double weight;
};
std::vector<LikelyNoise> likely_noises(const FittedSamples& fit);

// What each of these noises, of a variance of one, makes of the fit's parameters.
struct ParameterNoise {
  ParameterNoise(const FittedSamples& fit, std::vector<LikelyNoise> noises);

  std::vector<LikelyNoise> noises;
  std::vector<Eigen::MatrixXd> covariances;  // of the parameters, by noise
};

class LocalNoise {
 public:
  LocalNoise() = default;  // unknown
  // About this frequency [rad/s].
  LocalNoise(const FittedSamples& fit, double angular_frequency, double span,
             const ParameterNoise& of_parameters);

  // Whether the fit leaves a direction to tell the level by.
  bool known() const { return level_ >= 0; }

  // Half width of the 95 % interval of a quantity with this gradient by the first parameters;
  // infinite where the level is unknown.
  double half_width(const Eigen::VectorXd& gradient) const;

 private:
  struct Shape {
    double weighted_quantile;
    Eigen::MatrixXd covariance;  // of the parameters, for a mean level of one
  };
  double level_ = -1;  // root of the mean square of the projections
  std::vector<Shape> shapes_;
};

}  // namespace slosh

#include "verification/fits/local_noise.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

#include "verification/fits/dense_algebra.hpp"
#include "verification/fits/tone_search.hpp"
#include "verification/series/fourier_transform.hpp"
#include "verification/series/sample_moments.hpp"

namespace slosh {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

// The band reaches 2.5 spectral bins to either side: up to 10 degrees of freedom.
constexpr int half_band = 5;

// R x with R_ij = correlation^|i - j|.
MatrixXd correlated(const MatrixXd& columns, double correlation) {
  MatrixXd ahead = columns, behind = columns;
  const Index last = columns.rows() - 1;
  for (Index k = 0; k < columns.cols(); ++k) {
    for (Index i = 1; i <= last; ++i) {
      ahead(i, k) += correlation * ahead(i - 1, k);
      behind(last - i, k) += correlation * behind(last - i + 1, k);
    }
  }
  return ahead + behind - columns;
}

// The likelihood of a noise as a function of its correlation. Everything that does not depend on
// the correlation is computed once.
class RestrictedLikelihood {
 public:
  explicit RestrictedLikelihood(const FittedSamples& fit)
      : count_(static_cast<double>(fit.residual.size())), parameters_(fit.basis.cols()) {
    MatrixXd columns(fit.basis.rows(), parameters_ + 1);
    columns << fit.basis, fit.residual;
    const Index after_first = columns.rows() - 1;
    const auto later = columns.bottomRows(after_first), earlier = columns.topRows(after_first);
    first_ = columns.row(0).transpose() * columns.row(0);
    later_ = transposed_product(later, later);
    earlier_ = transposed_product(earlier, earlier);
    mixed_ = transposed_product(later, earlier);
    mixed_ += mixed_.transpose().eval();
  }

  // The logarithm of the likelihood, with the level eliminated.
  double log(double correlation) const {
    const double square = correlation * correlation;
    // These are the products of the columns after whitened().
    const MatrixXd products =
        first_ + (later_ - correlation * mixed_ + square * earlier_) / (1 - square);
    const MatrixXd normal = products.topLeftCorner(parameters_, parameters_);
    const VectorXd product = products.col(parameters_).head(parameters_);
    const double squares =
        products(parameters_, parameters_) - product.dot(SymmetricFactors(normal).solve(product));
    return -0.5 * ((count_ - 1) * std::log1p(-square) + log_determinant(normal) +
                   (count_ - static_cast<double>(parameters_)) * std::log(squares));
  }

 private:
  double count_;
  Index parameters_;
  MatrixXd first_, later_, earlier_, mixed_;
};

}  // namespace

MatrixXd whitened(const MatrixXd& columns, double correlation) {
  const Index after_first = columns.rows() - 1;
  MatrixXd white = columns;
  white.bottomRows(after_first) =
      (columns.bottomRows(after_first) - correlation * columns.topRows(after_first)) /
      std::sqrt(1 - correlation * correlation);
  return white;
}

MatrixXd band_about(const VectorXd& elapsed, double angular_frequency, double span, int half_band) {
  const MatrixXd tone = tone_columns(elapsed, {angular_frequency, 0});
  MatrixXd columns(elapsed.size(), 2 * (half_band + 1));
  for (int j = 0; j <= half_band; ++j) {
    const VectorXd envelope = tone_columns(elapsed, {j * std::numbers::pi / span, 0}).col(0);
    columns.middleCols<2>(2 * j) = envelope.asDiagonal() * tone;
  }
  return orthonormal(unit_columns(columns), 0.05);
}

std::vector<LikelyNoise> likely_noises(const FittedSamples& fit) {
  if (fit.residual.squaredNorm() == 0) return {{0, 1}};
  // The correlation times are 0, then double from half a sample to twice the window.
  const RestrictedLikelihood likelihood(fit);
  std::vector<LikelyNoise> noises{{0, likelihood.log(0)}};
  for (double samples = 0.5; samples < 2.0 * static_cast<double>(fit.elapsed.size()); samples *= 2)
    noises.push_back({std::exp(-1 / samples), likelihood.log(std::exp(-1 / samples))});
  double best = noises.front().weight, sum = 0;
  for (const LikelyNoise& noise : noises) best = std::max(best, noise.weight);
  for (LikelyNoise& noise : noises) sum += noise.weight = std::exp(noise.weight - best);
  for (LikelyNoise& noise : noises) noise.weight /= sum;
  std::erase_if(noises, [](const LikelyNoise& noise) { return !(noise.weight > 1e-3); });
  return noises;
}

ParameterNoise::ParameterNoise(const FittedSamples& fit, std::vector<LikelyNoise> likely)
    : noises(std::move(likely)) {
  const VectorXd scale = inverse_lengths(fit.jacobian);
  const MatrixXd scaled = fit.jacobian * scale.asDiagonal();
  const MatrixXd inverse = scale.asDiagonal() * pseudo_inverse(transposed_product(scaled, scaled));
  const MatrixXd weights = product(scaled, inverse.transpose());  // one column per parameter
  for (const LikelyNoise& noise : noises)
    covariances.push_back(transposed_product(weights, correlated(weights, noise.correlation)));
}

LocalNoise::LocalNoise(const FittedSamples& fit, double angular_frequency, double span,
                       const ParameterNoise& of_parameters) {
  const MatrixXd band = band_about(fit.elapsed, angular_frequency, span, half_band);
  const MatrixXd outside = band - product(fit.basis, transposed_product(fit.basis, band));
  // Directions that lie more than half in the range of the fit are left out.
  const MatrixXd directions = orthonormal(outside, 0.5);
  if (directions.cols() == 0) return;
  const auto count = static_cast<double>(directions.cols());
  level_ = (directions.transpose() * fit.residual).norm() / std::sqrt(count);
  for (std::size_t i = 0; i < of_parameters.noises.size(); ++i) {
    const auto& [correlation, weight] = of_parameters.noises[i];
    const MatrixXd variance = transposed_product(directions, correlated(directions, correlation));
    const double trace = variance.trace();
    const double freedom = trace * trace / variance.squaredNorm();
    shapes_.push_back({weight * t95(freedom), count / trace * of_parameters.covariances[i]});
  }
}

double LocalNoise::half_width(const VectorXd& gradient) const {
  if (!known()) return std::numeric_limits<double>::infinity();
  double factor = 0;
  for (const Shape& shape : shapes_) {
    const auto of_gradient = shape.covariance.topLeftCorner(gradient.size(), gradient.size());
    factor += shape.weighted_quantile * std::sqrt(gradient.dot(of_gradient * gradient));
  }
  return level_ * factor;
}

using Eigen::Index, Eigen::MatrixXcd, Eigen::MatrixXd, Eigen::VectorXd;
using std::numbers::pi;

TrialSpectrum::TrialSpectrum(const VectorXd& elapsed, double low, double high, double spacing,
                             const std::vector<double>& decay_rates,
                             const std::function<bool(const ToneShape&)>& admits) {
  const Index count = elapsed.size();
  const double interval = (elapsed[count - 1] - elapsed[0]) / static_cast<double>(count - 1);
  // The factor allows for round-off.
  const auto least = static_cast<Index>(std::ceil((1 - 1e-9) * 2 * pi / (spacing * interval)));
  length_ = fast_length(std::max(least, count));
  step_ = 2 * pi / (static_cast<double>(length_) * interval);
  // The transforms must also hold twice each frequency.
  const auto last = std::min(static_cast<Index>(high / step_), (length_ / 2) / 2);
  for (const double decay_rate : decay_rates) {
    OneDecay one{decay_rate, (-decay_rate * elapsed).array().exp(), {}, {}};
    one.squares = fourier_transforms(one.envelope.cwiseAbs2(), length_);
    for (auto place = static_cast<Index>(std::ceil(low / step_)); place <= last; ++place)
      if (admits({static_cast<double>(place) * step_, decay_rate})) one.places.push_back(place);
    decays_.push_back(std::move(one));
  }
}

bool TrialSpectrum::empty() const {
  return std::all_of(decays_.begin(), decays_.end(),
                     [](const OneDecay& one) { return one.places.empty(); });
}

ToneShape TrialSpectrum::best(const VectorXd& value, const MatrixXd& basis) const {
  MatrixXd columns(basis.rows(), basis.cols() + 1);
  columns << orthogonal_part(value, basis), basis;
  double most = -1;
  ToneShape found{};
  for (const OneDecay& one : decays_) {
    // The real parts are the products with the cosine, the imaginary parts the negative products
    // with the sine, of a tone whose phase counts from the first time.
    const MatrixXcd products =
        fourier_transforms(one.envelope.asDiagonal() * columns, length_).transpose();
    const double sum = one.squares[0].real();
    for (const Index place : one.places) {
      const std::complex<double> twice = one.squares[2 * place], left = products(0, place);
      const auto taken = products.col(place).tail(basis.cols());
      const double cosines = 0.5 * (sum + twice.real()) - taken.real().squaredNorm(),
                   sines = 0.5 * (sum - twice.real()) - taken.imag().squaredNorm(),
                   mixed = -0.5 * twice.imag() + taken.real().dot(taken.imag());
      const double c = left.real(), s = -left.imag();
      const double explained =
          (sines * c * c - 2 * mixed * c * s + cosines * s * s) / (cosines * sines - mixed * mixed);
      if (explained > most) {
        most = explained;
        found = {static_cast<double>(place) * step_, one.decay_rate};
      }
    }
  }
  return found;
}

}  // namespace slosh

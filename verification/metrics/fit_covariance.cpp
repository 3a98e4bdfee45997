#include "verification/metrics/fit_covariance.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

namespace slosh {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

// The autocovariance is used up to an eighth of the window, which gives the spectral estimate
// behind it 30 degrees of freedom (3.71 windows per longest lag, Priestley 1981). The
// fit of a tone takes up to four of them out of the residual: the rest is scaled up by 30 / 26, and
// the quantile is Student's for 26.
constexpr int windows_per_longest_lag = 8;
constexpr double removed_by_fit = 30.0 / 26.0, student_quantile = 2.0555;

double parzen(double x) {
  return x <= 0.5 ? 1 - 6 * x * x * (1 - x) : 2 * (1 - x) * (1 - x) * (1 - x);
}

}  // namespace

double FitCovariance::half_width(const VectorXd& gradient) const {
  return std::max(
      normal_quantile * std::sqrt(gradient.dot(white * gradient)),
      student_quantile * std::sqrt(removed_by_fit * gradient.dot(correlated * gradient)));
}

FitCovariance fit_covariance(const MatrixXd& jacobian, const VectorXd& residual) {
  // Columns of unit length, because those of w carry seconds and those of a weak tone vanish.
  const VectorXd length =
      jacobian.colwise().norm().transpose().cwiseMax(std::numeric_limits<double>::min());
  const MatrixXd scaled = jacobian * length.cwiseInverse().asDiagonal();
  const MatrixXd normal = scaled.transpose() * scaled;
  const MatrixXd inverse = normal.completeOrthogonalDecomposition().pseudoInverse();

  const Index count = residual.size(),
              longest = std::max<Index>(1, count / windows_per_longest_lag);
  const auto freedom = static_cast<double>(count - jacobian.cols());
  MatrixXd correlated = residual.squaredNorm() / freedom * scaled;
  for (Index lag = 1; lag < longest; ++lag) {
    const Index overlap = count - lag;
    const double autocovariance = residual.head(overlap).dot(residual.tail(overlap)) / freedom *
                                  parzen(static_cast<double>(lag) / static_cast<double>(longest));
    correlated.topRows(overlap) += autocovariance * scaled.bottomRows(overlap);
    correlated.bottomRows(overlap) += autocovariance * scaled.topRows(overlap);
  }
  const auto rescale = [&](const MatrixXd& matrix) -> MatrixXd {
    return length.cwiseInverse().asDiagonal() * matrix * length.cwiseInverse().asDiagonal();
  };
  return {.white = rescale(residual.squaredNorm() / freedom * inverse),
          .correlated = rescale(inverse * (scaled.transpose() * correlated) * inverse)};
}

}  // namespace slosh

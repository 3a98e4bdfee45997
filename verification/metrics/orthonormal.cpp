#include "verification/metrics/orthonormal.hpp"

#include <Eigen/Eigenvalues>
#include <limits>

namespace slosh {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

VectorXd inverse_lengths(const MatrixXd& columns) {
  return columns.colwise()
      .norm()
      .transpose()
      .cwiseMax(std::numeric_limits<double>::min())
      .cwiseInverse();
}

MatrixXd unit_columns(const MatrixXd& columns) {
  return columns * inverse_lengths(columns).asDiagonal();
}

MatrixXd orthonormal(const MatrixXd& columns, double least) {
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen((columns.transpose() * columns).eval());
  // The eigenvalues ascend: those to keep are the last.
  const Index kept = (eigen.eigenvalues().array() > least).count();
  const VectorXd lengths = eigen.eigenvalues().tail(kept).cwiseSqrt();
  return columns * (eigen.eigenvectors().rightCols(kept) * lengths.cwiseInverse().asDiagonal());
}

VectorXd orthogonal_part(VectorXd value, const MatrixXd& basis) {
  // Once more, of what round-off has left.
  for (int pass = 0; pass < 2; ++pass) value -= basis * (basis.transpose() * value);
  return value;
}

}  // namespace slosh

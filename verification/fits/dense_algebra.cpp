#include "verification/fits/dense_algebra.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <limits>

namespace slosh {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

MatrixXd product(const MatrixView& a, const MatrixView& b) { return a * b; }

MatrixXd transposed_product(const MatrixView& a, const MatrixView& b) { return a.transpose() * b; }

SymmetricFactors::SymmetricFactors(const MatrixXd& matrix) : factors_(matrix) {}

VectorXd SymmetricFactors::solve(const VectorXd& right) const { return factors_.solve(right); }

MatrixXd SymmetricFactors::solve_columns(const MatrixXd& right) const {
  return factors_.solve(right);
}

double log_determinant(const MatrixXd& positive) {
  return positive.llt().matrixLLT().diagonal().array().log().sum() * 2;
}

MatrixXd pseudo_inverse(const MatrixXd& matrix) {
  return matrix.completeOrthogonalDecomposition().pseudoInverse();
}

VectorXd least_squares(const MatrixXd& columns, const VectorXd& values) {
  return columns.colPivHouseholderQr().solve(values);
}

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
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(transposed_product(columns, columns));
  // The eigenvalues ascend, so that those to keep come last.
  const Index kept = (eigen.eigenvalues().array() > least).count();
  const VectorXd lengths = eigen.eigenvalues().tail(kept).cwiseSqrt();
  return product(columns,
                 eigen.eigenvectors().rightCols(kept) * lengths.cwiseInverse().asDiagonal());
}

VectorXd orthogonal_part(VectorXd value, const MatrixXd& basis) {
  // The second pass removes the error that round-off leaves.
  for (int pass = 0; pass < 2; ++pass) value -= basis * (basis.transpose() * value);
  return value;
}

}  // namespace slosh

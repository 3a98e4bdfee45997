// Products, decompositions and bases of dense matrices. All are Eigen's, compiled in this one file,
// because the templates would dominate the compile time of every file that used them.
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>

namespace slosh {

// A matrix, or a block of its rows or columns.
using MatrixView = Eigen::Ref<const Eigen::MatrixXd>;

// a b, with a of m x k and b of k x n.
Eigen::MatrixXd product(const MatrixView& a, const MatrixView& b);

// a^T b, with a of k x m and b of k x n.
Eigen::MatrixXd transposed_product(const MatrixView& a, const MatrixView& b);

// Solves linear systems with one symmetric positive semidefinite matrix (Cholesky, L D L^T).
class SymmetricFactors {
 public:
  SymmetricFactors() = default;
  explicit SymmetricFactors(const Eigen::MatrixXd& matrix);

  // The solution x of matrix x = right; solve_columns() solves for each column of `right`.
  Eigen::VectorXd solve(const Eigen::VectorXd& right) const;
  Eigen::MatrixXd solve_columns(const Eigen::MatrixXd& right) const;

 private:
  Eigen::LDLT<Eigen::MatrixXd> factors_;
};

// The logarithm of the determinant of a symmetric positive definite matrix.
double log_determinant(const Eigen::MatrixXd& positive);

// The Moore-Penrose inverse of any matrix.
Eigen::MatrixXd pseudo_inverse(const Eigen::MatrixXd& matrix);

// The x for which |columns x - values| is least (QR with pivots).
Eigen::VectorXd least_squares(const Eigen::MatrixXd& columns, const Eigen::VectorXd& values);

// One over each column's length.
Eigen::VectorXd inverse_lengths(const Eigen::MatrixXd& columns);

// The columns scaled to unit length. Without it, the columns of a weak tone would vanish beside
// those that are multiplied by the time.
Eigen::MatrixXd unit_columns(const Eigen::MatrixXd& columns);

// Orthonormal columns that span the given ones, without the directions in which the sum of their
// squares is at most `least`.
Eigen::MatrixXd orthonormal(const Eigen::MatrixXd& columns, double least);

// The part of the values that is orthogonal to an orthonormal basis.
Eigen::VectorXd orthogonal_part(Eigen::VectorXd value, const Eigen::MatrixXd& basis);

}  // namespace slosh

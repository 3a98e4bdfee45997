// Products, decompositions and bases of dense matrices. They are Eigen's, all compiled in one file:
// their templates would take most of the compilation of every file that used them.
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>

namespace slosh {

// A matrix, or a block of the rows or columns of one.
using MatrixView = Eigen::Ref<const Eigen::MatrixXd>;

// a b, of m x k and k x n.
Eigen::MatrixXd product(const MatrixView& a, const MatrixView& b);

// a^T b, of k x m and k x n.
Eigen::MatrixXd transposed_product(const MatrixView& a, const MatrixView& b);

// Solves equations of one symmetric positive semidefinite matrix (Cholesky, L D L^T).
class SymmetricFactors {
 public:
  SymmetricFactors() = default;
  explicit SymmetricFactors(const Eigen::MatrixXd& matrix);

  // x of matrix x = right; of each column of `right`.
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

// The columns at unit length: those of a weak tone would vanish beside those that carry seconds.
Eigen::MatrixXd unit_columns(const Eigen::MatrixXd& columns);

// Orthonormal columns that span these, without the directions in which their squares sum to no
// more than `least`.
Eigen::MatrixXd orthonormal(const Eigen::MatrixXd& columns, double least);

// What is orthogonal to an orthonormal basis.
Eigen::VectorXd orthogonal_part(Eigen::VectorXd value, const Eigen::MatrixXd& basis);

}  // namespace slosh

// Products and decompositions of dense matrices. All are Eigen's, compiled in one file, because
// their templates would take most of the compilation of every file that used them.
#pragma once

#include <Eigen/Core>

namespace slosh::reference {

// A matrix, a block of one, or an expression, which is evaluated.
using MatrixView = Eigen::Ref<const Eigen::MatrixXd>;

// a b, with a of m x k and b of k x n.
Eigen::MatrixXd product(const MatrixView& a, const MatrixView& b);

// a^T b, with a of k x m and b of k x n.
Eigen::MatrixXd transposed_product(const MatrixView& a, const MatrixView& b);

struct Eigenpairs {
  Eigen::VectorXd values;   // rising
  Eigen::MatrixXd vectors;  // a column each
};

// The values and vectors of stiffness v = value mass v, with v . mass v = 1. Both matrices are
// symmetric, the mass is positive definite.
Eigenpairs generalized_eigenpairs(const Eigen::MatrixXd& stiffness, const Eigen::MatrixXd& mass);

// Those of the symmetric tridiagonal matrix with a zero diagonal, with v . v = 1.
Eigenpairs tridiagonal_eigenpairs(const Eigen::VectorXd& off_diagonal);

Eigen::MatrixXd inverse(const Eigen::MatrixXd& matrix);

// The solution of matrix x = right for each column of `right`, by the Cholesky factors of a
// symmetric positive definite matrix.
Eigen::MatrixXd solve_positive(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right);

}  // namespace slosh::reference

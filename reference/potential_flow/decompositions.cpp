#include "reference/potential_flow/decompositions.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>

namespace slosh::reference {

using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd product(const MatrixView& a, const MatrixView& b) { return a * b; }

MatrixXd transposed_product(const MatrixView& a, const MatrixView& b) { return a.transpose() * b; }

Eigenpairs generalized_eigenpairs(const MatrixXd& stiffness, const MatrixXd& mass) {
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> solver(stiffness, mass);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

Eigenpairs tridiagonal_eigenpairs(const VectorXd& off_diagonal) {
  Eigen::SelfAdjointEigenSolver<MatrixXd> solver;
  solver.computeFromTridiagonal(VectorXd::Zero(off_diagonal.size() + 1), off_diagonal);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

MatrixXd inverse(const MatrixXd& matrix) { return matrix.inverse(); }

MatrixXd solve_positive(const MatrixXd& matrix, const MatrixXd& right) {
  return matrix.llt().solve(right);
}

}  // namespace slosh::reference

// The matrix-free solution of large linear systems.
#pragma once

#include <Eigen/Core>
#include <functional>

namespace slosh::sph {

struct LinearSolution {
  Eigen::VectorXd x;
  int iterations;
  double relative_residual;
};

// Solves apply(x) = right_side by GMRES (Eigen), restarted every 50 steps and without
// preconditioner, up to the relative residual `tolerance` or `most` iterations. The caller has to
// check the residual of the solution.
LinearSolution solve(const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& apply,
                     const Eigen::VectorXd& right_side, double tolerance, int most);

}  // namespace slosh::sph

// Large linear systems that are only known by what they do to a vector.
#pragma once

#include <Eigen/Core>
#include <functional>

namespace slosh::sph {

struct LinearSolution {
  Eigen::VectorXd x;
  int iterations;
  double relative_residual;
};

// Solves apply(x) = right_side by GMRES (Eigen), restarted every 50 steps, without preconditioner,
// to the relative residual `tolerance` or to as many iterations as `most`; the caller looks at the
// residual that is left.
LinearSolution solve(const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& apply,
                     const Eigen::VectorXd& right_side, double tolerance, int most);

}  // namespace slosh::sph

// Covariances of the parameters of a least-squares fit, from its Jacobian and what it leaves:
// s^2 (J^T J)^-1 were the residuals white, and (J^T J)^-1 J^T R J (J^T J)^-1 with R their
// autocovariance tapered by Parzen's window (Priestley 1981; Newey & West 1987).
#pragma once

#include <Eigen/Core>

namespace slosh {

inline constexpr double normal_quantile = 1.959964;  // two-sided 95 %

struct FitCovariance {
  Eigen::MatrixXd white, correlated;

  // Half width of the 95 % interval of a quantity with this gradient: never below the one for white
  // residuals.
  double half_width(const Eigen::VectorXd& gradient) const;
};

// `residual` at the Jacobian's rows, equally spaced in time.
FitCovariance fit_covariance(const Eigen::MatrixXd& jacobian, const Eigen::VectorXd& residual);

}  // namespace slosh

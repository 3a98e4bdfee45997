// The Gauss-Lobatto-Legendre grid of an interval: with n nodes, ends included, its quadrature is
// exact up to the degree 2n - 3, and its derivative and interpolation for the polynomial of degree
// n - 1 through the nodes (Canuto, Hussaini, Quarteroni & Zang, Spectral Methods: Fundamentals in
// Single Domains, 2006, section 2.3). A smooth function is represented with an error that falls
// faster than any power of n, and one with a weak singularity at an end as d^2 log d, d the
// distance, as n^-4: the nodes crowd there.
#pragma once

#include <Eigen/Dense>

namespace slosh::reference {

class LegendreGrid {
 public:
  // Throws std::invalid_argument for fewer than 4 nodes.
  LegendreGrid(double from, double to, int nodes);

  Eigen::VectorXd nodes, weights;  // rising, [n]
  Eigen::MatrixXd derivative;      // of the values at the nodes, [n x n]
  // Values at the nodes to the coefficients of the Legendre polynomials P_0 to P_(n-1), [n x n].
  Eigen::MatrixXd coefficients;

  // The row that interpolates values at the nodes to x, from <= x <= to.
  Eigen::RowVectorXd interpolation(double x) const;

 private:
  Eigen::VectorXd barycentric_;
};

}  // namespace slosh::reference

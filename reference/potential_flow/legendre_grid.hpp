// The Gauss-Lobatto-Legendre grid of an interval. With n nodes, the ends included, the quadrature
// is exact up to degree 2n - 3, and the derivative and interpolation are those of the polynomial of
// degree n - 1 through the nodes (Canuto, Hussaini, Quarteroni & Zang, Spectral Methods:
// Fundamentals in Single Domains, 2006, section 2.3). The error falls faster than any power of n
// for a smooth function. For a weak singularity d^2 log d at a distance d from an end it falls as
// n^-4, because the nodes are dense there.
#pragma once

#include <Eigen/Core>

namespace slosh::reference {

class LegendreGrid {
 public:
  // Throws std::invalid_argument for fewer than 4 nodes.
  LegendreGrid(double from, double to, int nodes);

  Eigen::VectorXd nodes, weights;  // ascending, [n]
  Eigen::MatrixXd derivative;      // maps values at the nodes to derivatives there, [n x n]
  // Maps values at the nodes to the coefficients of the Legendre polynomials P_0 to P_(n-1),
  // [n x n].
  Eigen::MatrixXd coefficients;

  // Returns the row that interpolates values at the nodes to x, from <= x <= to.
  Eigen::RowVectorXd interpolation(double x) const;

 private:
  Eigen::VectorXd barycentric_;
};

}  // namespace slosh::reference

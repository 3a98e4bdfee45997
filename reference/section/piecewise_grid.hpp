// Continuous piecewise polynomials on an interval, each piece on a Gauss-Lobatto-Legendre grid
// (potential_flow/legendre_grid.hpp), and Gauss's quadrature that integrates their products.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "reference/potential_flow/legendre_grid.hpp"

namespace slosh::reference {

class PiecewiseGrid {
 public:
  // `breaks` ascend; there is a degree, 3 or more, for each piece between two of them. Quadrature
  // is exact up to the degree 2 p + 3 in a piece of degree p.
  PiecewiseGrid(const std::vector<double>& breaks, const std::vector<int>& degrees);

  Eigen::Index size() const { return size_; }  // the number of nodes
  // The rows that map values at the nodes to the value and the derivative at a place.
  struct Rows {
    Eigen::RowVectorXd value, slope;
  };
  Rows at(double place) const;

  Eigen::VectorXd nodes;  // ascending, [size]
  // At the points of quadrature, [points], and the rows there, [points x size].
  Eigen::VectorXd points, weights;
  Eigen::MatrixXd values, slopes;

 private:
  std::vector<LegendreGrid> pieces_;
  Eigen::Index size_ = 1;
};

}  // namespace slosh::reference

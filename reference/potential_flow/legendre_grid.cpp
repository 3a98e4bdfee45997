#include "reference/potential_flow/legendre_grid.hpp"

#include <cmath>
#include <numbers>

#include "reference/require.hpp"

namespace slosh::reference {
namespace {

// Returns P_0 to P_degree at x in [-1, 1].
Eigen::VectorXd legendre(int degree, double x) {
  Eigen::VectorXd p(degree + 1);
  p[0] = 1;
  p[1] = x;
  for (int k = 1; k < degree; ++k) p[k + 1] = ((2 * k + 1) * x * p[k] - k * p[k - 1]) / (k + 1);
  return p;
}

// Returns the i-th zero of (1 - x^2) P'_degree, by Newton's method from the nearby Chebyshev point.
double lobatto_node(int degree, int i) {
  double x = -std::cos(std::numbers::pi * i / degree);
  for (int iteration = 0; iteration < 50; ++iteration) {
    const Eigen::VectorXd p = legendre(degree, x);
    const double step = (x * p[degree] - p[degree - 1]) / ((degree + 1) * p[degree]);
    x -= step;
    if (std::abs(step) < 1e-15) break;  // some five times the spacing of doubles near 1
  }
  return x;
}

}  // namespace

LegendreGrid::LegendreGrid(double from, double to, int count)
    : nodes(count), weights(count), derivative(count, count), coefficients(count, count) {
  require(count >= 4, "LegendreGrid", "number of nodes", count, "4 or more");
  const int degree = count - 1;
  const double half = (to - from) / 2;
  barycentric_.resize(count);
  Eigen::VectorXd reduced(count);
  for (int i = 0; i < count; ++i) {
    // The grid is symmetric to the last digit.
    reduced[i] = i < count / 2 ? lobatto_node(degree, i) : -lobatto_node(degree, degree - i);
    const Eigen::VectorXd p = legendre(degree, reduced[i]);
    const double weight = 2 / (degree * (degree + 1) * p[degree] * p[degree]);
    nodes[i] = (from + to) / 2 + half * reduced[i];
    weights[i] = half * weight;
    barycentric_[i] = 1 / p[degree];
    for (int k = 0; k < degree; ++k) coefficients(k, i) = (k + 0.5) * weight * p[k];
    coefficients(degree, i) = 0.5 * degree * weight * p[degree];
  }
  nodes[0] = from;
  nodes[degree] = to;
  for (int i = 0; i < count; ++i) {
    derivative(i, i) = 0;
    for (int j = 0; j < count; ++j) {
      if (j == i) continue;
      derivative(i, j) = barycentric_[j] / barycentric_[i] / (half * (reduced[i] - reduced[j]));
    }
    derivative(i, i) = -derivative.row(i).sum();  // a constant's derivative is zero to rounding
  }
}

Eigen::RowVectorXd LegendreGrid::interpolation(double x) const {
  const Eigen::ArrayXd distance = x - nodes.array();
  Eigen::Index at;
  if (distance.abs().minCoeff(&at) == 0) return Eigen::RowVectorXd::Unit(nodes.size(), at);
  const Eigen::RowVectorXd shares = barycentric_.array() / distance;
  return shares / shares.sum();
}

}  // namespace slosh::reference

// The cubic spline through points at irregular places. It is twice continuously differentiable, the
// third derivative continuous at the second and the last but one point too ("not-a-knot": C. de
// Boor, A Practical Guide to Splines, 1978, chapter IV), so that any cubic is reproduced exactly
// and nothing is assumed at the ends. With m the second derivatives and h the lengths of the
// intervals:
//   h_(i-1) m_(i-1) + 2 (h_(i-1) + h_i) m_i + h_i m_(i+1) = 6 ((y_(i+1) - y_i)/h_i - (y_i -
//   y_(i-1))/h_(i-1))
// Beyond the ends the outermost cubics continue.
#pragma once

#include <cstddef>
#include <vector>

namespace slosh {

class CubicSpline {
 public:
  // At least four points, x strictly increasing.
  CubicSpline(std::vector<double> x, std::vector<double> y);

  double value(double x) const;
  double first_derivative(double x) const;
  double second_derivative(double x) const;

 private:
  std::size_t interval(double x) const;

  std::vector<double> x_, y_;
  std::vector<double> curvature_;  // second derivative at each point
};

}  // namespace slosh

#include "verification/case/cubic_spline.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

namespace slosh {
namespace {

// Second derivatives at all points: the tridiagonal system of the inner ones, the ends eliminated
// by the not-a-knot condition, solved by elimination without pivoting (its rows are diagonally
// dominant enough).
std::vector<double> second_derivatives(const std::vector<double>& x, const std::vector<double>& y) {
  const std::size_t n = x.size();
  const auto h = [&](std::size_t i) { return x[i + 1] - x[i]; };
  const auto slope = [&](std::size_t i) { return (y[i + 1] - y[i]) / h(i); };
  std::vector<double> lower(n), diagonal(n), upper(n), m(n);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    lower[i] = h(i - 1);
    diagonal[i] = 2 * (h(i - 1) + h(i));
    upper[i] = h(i);
    m[i] = 6 * (slope(i) - slope(i - 1));
  }
  const double first_ratio = h(0) / h(1), last_ratio = h(n - 2) / h(n - 3);
  diagonal[1] += h(0) * (1 + first_ratio);
  upper[1] -= h(0) * first_ratio;
  diagonal[n - 2] += h(n - 2) * (1 + last_ratio);
  lower[n - 2] -= h(n - 2) * last_ratio;
  for (std::size_t i = 2; i + 1 < n; ++i) {
    const double factor = lower[i] / diagonal[i - 1];
    diagonal[i] -= factor * upper[i - 1];
    m[i] -= factor * m[i - 1];
  }
  m[n - 2] /= diagonal[n - 2];
  for (std::size_t i = n - 3; i >= 1; --i) m[i] = (m[i] - upper[i] * m[i + 1]) / diagonal[i];
  m[0] = m[1] + first_ratio * (m[1] - m[2]);
  m[n - 1] = m[n - 2] + last_ratio * (m[n - 2] - m[n - 3]);
  return m;
}

}  // namespace

CubicSpline::CubicSpline(std::vector<double> x, std::vector<double> y)
    : x_(std::move(x)), y_(std::move(y)) {
  assert(x_.size() >= 4 && x_.size() == y_.size());
  curvature_ = second_derivatives(x_, y_);
}

std::size_t CubicSpline::interval(double x) const {
  const auto after = std::upper_bound(x_.begin() + 1, x_.end() - 1, x);
  return static_cast<std::size_t>(after - x_.begin()) - 1;
}

double CubicSpline::value(double x) const {
  const std::size_t i = interval(x);
  const double h = x_[i + 1] - x_[i], left = x_[i + 1] - x, right = x - x_[i];
  return (curvature_[i] * left * left * left + curvature_[i + 1] * right * right * right) /
             (6 * h) +
         (y_[i] / h - curvature_[i] * h / 6) * left +
         (y_[i + 1] / h - curvature_[i + 1] * h / 6) * right;
}

double CubicSpline::first_derivative(double x) const {
  const std::size_t i = interval(x);
  const double h = x_[i + 1] - x_[i], left = x_[i + 1] - x, right = x - x_[i];
  return (curvature_[i + 1] * right * right - curvature_[i] * left * left) / (2 * h) +
         (y_[i + 1] - y_[i]) / h - (curvature_[i + 1] - curvature_[i]) * h / 6;
}

double CubicSpline::second_derivative(double x) const {
  const std::size_t i = interval(x);
  const double h = x_[i + 1] - x_[i];
  return (curvature_[i] * (x_[i + 1] - x) + curvature_[i + 1] * (x - x_[i])) / h;
}

}  // namespace slosh

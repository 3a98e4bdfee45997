// A direct numerical solution of the viscous standing wave: the linear Navier-Stokes equations of
// one Fourier mode along x, u(z,t) sin kx, (w, p)(z,t) cos kx, eta(t) cos kx, from rest,
//   u_t = k p + nu (u'' - k^2 u),  w_t = -p' + nu (w'' - k^2 w),  k u + w' = 0,  eta_t = w(0),
//   z = 0: u' = k w, p = g eta + 2 nu w';   z = -h: w = 0, u' = 0   (density 1).
// They are solved by Chebyshev collocation in z and Radau's two-stage method of third order in t
// (Hairer & Wanner, Solving Ordinary Differential Equations II, table IV.5.5).
#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <numbers>
#include <vector>

namespace slosh::reference {

struct LiquidMode {
  double k, depth, gravity, nu;
};

// Returns the derivative on the points z_j = depth (cos(pi j / n) - 1) / 2, j = 0 ... n (Trefethen,
// Spectral Methods, ch. 6).
inline Eigen::MatrixXd chebyshev_derivative(int n, double depth) {
  const auto x = [n](int j) { return std::cos(std::numbers::pi * j / n); };
  const auto weight = [n](int j) { return (j % n == 0 ? 2.0 : 1.0) * (j % 2 == 0 ? 1 : -1); };
  Eigen::MatrixXd d(n + 1, n + 1);
  for (int i = 0; i <= n; ++i) {
    d(i, i) = 0;
    for (int j = 0; j <= n; ++j)
      if (i != j) d(i, j) = weight(i) / weight(j) / (x(i) - x(j));
    d(i, i) = -d.row(i).sum();
  }
  return d * (2 / depth);
}

// Returns eta / eta(0) at 0, step, ..., steps * step.
inline std::vector<double> height_by_collocation(const LiquidMode& mode, int n, double step,
                                                 int steps) {
  const auto& [k, depth, gravity, nu] = mode;
  const int points = n + 1, w = 0, u = points, p = 2 * points, eta = 3 * points, size = eta + 1;
  const Eigen::MatrixXd d = chebyshev_derivative(n, depth);
  const Eigen::MatrixXd one = Eigen::MatrixXd::Identity(points, points);
  const Eigen::MatrixXd friction = nu * (d * d - k * k * one);
  // The system is B y' = A y. The equations are set at every point, and the boundary conditions
  // then replace those at the end points.
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(size, size), b = a;
  a.block(w, w, points, points) = a.block(u, u, points, points) = friction;
  a.block(w, p, points, points) = -d;
  a.block(u, p, points, points) = a.block(p, u, points, points) = k * one;
  a.block(p, w, points, points) = d;
  b.block(w, w, points, points) = b.block(u, u, points, points) = one;
  a(eta, w) = b(eta, eta) = 1;
  for (const int row : {w, w + n, u, u + n}) a.row(row).setZero(), b.row(row).setZero();
  a(w, p) = 1, a(w, eta) = -gravity, a.block(w, w, 1, points) = -2 * nu * d.row(0);
  a(w + n, w + n) = 1;
  a.block(u, u, 1, points) = d.row(0), a(u, w) = -k;
  a.block(u + n, u, 1, points) = d.row(n);

  Eigen::MatrixXd stages(2 * size, 2 * size);
  stages << b - step * 5 / 12 * a, step / 12 * a, -step * 3 / 4 * a, b - step / 4 * a;
  const Eigen::PartialPivLU<Eigen::MatrixXd> solve(stages);
  Eigen::VectorXd state = Eigen::VectorXd::Zero(size);
  state(eta) = 1;
  std::vector<double> heights{1};
  for (int i = 0; i < steps; ++i) {
    const Eigen::VectorXd before = b * state;
    Eigen::VectorXd both(2 * size);
    both << before, before;
    state = solve.solve(both).tail(size);
    heights.push_back(state(eta));
  }
  return heights;
}

}  // namespace slosh::reference

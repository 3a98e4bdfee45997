// A liquid and a gas in a moving rectangular tank, as an initial-value problem without natural
// modes: Galerkin's method with products of Legendre polynomials in each layer, in the earth's
// frame.
//   Phi of each layer is harmonic, with the normal velocity q' b of walls, bottom and roof, and
//   Phi_z = q' b + eta' on the surface from both sides;
//   the pressures -rho (Phi_t + g (z + x tilt q)) of both layers are equal on the surface.
// In a surge b is that of a unit velocity along x, in a roll that of a unit rate about the axis.
// The equations for the coefficients of eta are integrated by Dormand and Prince's method.
#pragma once

#include <Eigen/Dense>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/special_functions/legendre.hpp>
#include <boost/numeric/odeint.hpp>
#include <functional>
#include <vector>

#include "reference/tank.hpp"

namespace slosh::reference {

// q(t) and its derivatives; X in a surge, theta in a roll about (axis_x, axis_z).
struct LayersMotion {
  bool rolls;
  std::function<double(double)> place, rate, acceleration;
  double axis_x = 0, axis_z = 0;

  // The velocity of a wall's point for a unit q'.
  double x(double z) const { return rolls ? -(z - axis_z) : 1; }
  double z(double x) const { return rolls ? x - axis_x : 0; }
};

// Returns the integral of f, exact for polynomials up to the degree 119.
template <class Function>
double gauss(double from, double to, const Function& f) {
  return boost::math::quadrature::gauss<double, 60>::integrate(f, from, to);
}

// One layer between the heights `low` and `high`, one of which is 0, the surface.
class Layer {
 public:
  Layer(const Tank& tank, double density, double low, double high, const LayersMotion& motion,
        int degree)
      : density(density), a_(tank.length / 2), low_(low), high_(high), degree_(degree) {
    const int n = degree + 1;
    Eigen::MatrixXd stiffness(n * n - 1, n * n - 1);
    const Eigen::MatrixXd mass = integrals(false), slopes = integrals(true);
    const double aspect = (high - low) / (2 * a_);
    for (int r = 1; r < n * n; ++r)
      for (int c = 1; c < n * n; ++c)
        stiffness(r - 1, c - 1) = slopes(r / n, c / n) * mass(r % n, c % n) * aspect +
                                  mass(r / n, c / n) * slopes(r % n, c % n) / aspect;
    const bool below = high == 0;
    const double outward = below ? 1 : -1;  // the normal of the surface
    Eigen::MatrixXd loads(n * n - 1, n);    // of the motion, and of each polynomial of eta'
    for (int r = 1; r < n * n; ++r) {
      const int i = r / n, j = r % n;
      const auto across = [&](double x) { return boost::math::legendre_p(i, x / a_); };
      const double on_walls = gauss(low, high, [&](double z) {
        return motion.x(z) * (across(a_) - across(-a_)) * boost::math::legendre_p(j, scaled(z));
      });
      const double on_ends = gauss(-a_, a_, [&](double x) {
        return motion.z(x) * across(x) * (1 - boost::math::legendre_p(j, -1.0));
      });
      loads(r - 1, 0) = on_walls + on_ends;
      for (int m = 1; m < n; ++m)
        loads(r - 1, m) = outward * boost::math::legendre_p(j, below ? 1.0 : -1.0) *
                          (i == m ? 2 * a_ / (2 * m + 1) : 0);
    }
    potentials = stiffness.ldlt().solve(loads);
  }

  // The layer's polynomials at a place.
  Eigen::RowVectorXd at(double x, double z) const {
    const int n = degree_ + 1;
    Eigen::MatrixXd products(n, n);  // the order along z by that along x
    for (int i = 0; i < n; ++i) products.col(i).setConstant(boost::math::legendre_p(i, x / a_));
    for (int j = 0; j < n; ++j) products.row(j) *= boost::math::legendre_p(j, scaled(z));
    return products.reshaped().tail(n * n - 1).transpose();
  }

  // The integral over the surface of each potential times P_m, m = 1, 2, ...: row m - 1.
  Eigen::MatrixXd on_surface() const {
    const int n = degree_ + 1;
    Eigen::MatrixXd projections = Eigen::MatrixXd::Zero(degree_, n);
    for (int m = 1; m < n; ++m)
      for (int j = 0; j < n; ++j)
        projections.row(m - 1) += 2 * a_ / (2 * m + 1) * boost::math::legendre_p(j, scaled(0)) *
                                  potentials.row(m * n + j - 1);
    return projections;
  }

  double density;
  Eigen::MatrixXd potentials;  // of q', and of each polynomial of eta'

 private:
  double scaled(double z) const { return (2 * z - low_ - high_) / (high_ - low_); }

  Eigen::MatrixXd integrals(bool of_slopes) const {
    const auto f = [&](int i, double s) {
      return of_slopes ? boost::math::legendre_p_prime(i, s) : boost::math::legendre_p(i, s);
    };
    Eigen::MatrixXd matrix(degree_ + 1, degree_ + 1);
    for (int i = 0; i <= degree_; ++i)
      for (int j = 0; j <= degree_; ++j)
        matrix(i, j) = gauss(-1, 1, [&](double s) { return f(i, s) * f(j, s); });
    return matrix;
  }

  double a_, low_, high_;
  int degree_;
};

class TwoLayerGalerkin {
 public:
  TwoLayerGalerkin(const Tank& tank, const Gas& gas, Start start, LayersMotion motion, int degree)
      : tank_(tank),
        motion_(std::move(motion)),
        degree_(degree),
        roof_(gas.height),
        liquid_(tank, tank.density, -tank.fill_depth, 0, motion_, degree),
        gas_(tank, gas.density, 0, gas.height, motion_, degree) {
    const Eigen::MatrixXd rise =
        liquid_.density * liquid_.on_surface() - gas_.density * gas_.on_surface();
    const double weight = tank.gravity * (liquid_.density - gas_.density);
    Eigen::VectorXd norm(degree), line = Eigen::VectorXd::Zero(degree);  // x = a P_1
    for (int m = 1; m <= degree; ++m) norm(m - 1) = tank.length / (2 * m + 1);
    line(0) = motion_.rolls ? norm(0) * tank.length / 2 : 0;
    const Eigen::LDLT<Eigen::MatrixXd> inertia(rise.rightCols(degree));
    stiffness_ = inertia.solve(Eigen::MatrixXd(weight * norm.asDiagonal()));
    tilt_ = inertia.solve(weight * line);
    push_ = inertia.solve(rise.col(0));
    state_.assign(2 * degree, 0);
    if (start == Start::earth)
      Eigen::Map<Eigen::VectorXd>(state_.data() + degree, degree) = -push_ * motion_.rate(0);
  }

  // Goes on to a later time.
  void advance(double t) {
    namespace odeint = boost::numeric::odeint;
    using State = std::vector<double>;
    odeint::integrate_adaptive(
        odeint::make_controlled(1e-12, 1e-12, odeint::runge_kutta_dopri5<State>()),
        [&](const State& y, State& rate, double time) {
          std::copy(y.begin() + degree_, y.end(), rate.begin());
          Eigen::Map<Eigen::VectorXd>(rate.data() + degree_, degree_) = acceleration(y, time);
        },
        state_, time_, t, 1e-4);
    time_ = t;
  }

  double elevation(double x) const {
    double sum = 0;
    for (int m = 1; m <= degree_; ++m)
      sum += state_[m - 1] * boost::math::legendre_p(m, 2 * x / tank_.length);
    return sum;
  }
  // In the liquid, or above the surface in the gas; 0 in the middle of the surface.
  double pressure(double x, double z) const {
    const Layer& layer = z > 0 ? gas_ : liquid_;
    return absolute(layer, x, z) - absolute(layer, 0, 0);
  }
  // Of both on the tank.
  double force_x() const {
    return on_walls([](double) { return 1; });
  }
  double force_z() const {
    return on_ends([](double) { return 1; });
  }
  double moment() const {
    return on_ends([&](double x) { return x - motion_.axis_x; }) -
           on_walls([&](double z) { return z - motion_.axis_z; });
  }

 private:
  Eigen::VectorXd acceleration(const std::vector<double>& y, double t) const {
    return -(stiffness_ * Eigen::Map<const Eigen::VectorXd>(y.data(), degree_) +
             tilt_ * motion_.place(t) + push_ * motion_.acceleration(t));
  }
  double absolute(const Layer& layer, double x, double z) const {
    Eigen::VectorXd rates(degree_ + 1);
    rates << motion_.acceleration(time_), acceleration(state_, time_);
    const double tilt = motion_.rolls ? motion_.place(time_) : 0;
    return -layer.density *
           (layer.at(x, z).dot(layer.potentials * rates) + tank_.gravity * (z + x * tilt));
  }
  template <class Arm>
  double on_walls(const Arm& arm) const {
    const auto push = [&](double z) {
      return arm(z) * (pressure(tank_.length / 2, z) - pressure(-tank_.length / 2, z));
    };
    return gauss(-tank_.fill_depth, 0, push) + gauss(0, roof_, push);
  }
  template <class Arm>
  double on_ends(const Arm& arm) const {
    return gauss(-tank_.length / 2, tank_.length / 2, [&](double x) {
      return arm(x) * (pressure(x, roof_) - pressure(x, -tank_.fill_depth));
    });
  }

  Tank tank_;
  LayersMotion motion_;
  int degree_;
  double roof_;
  Layer liquid_, gas_;
  Eigen::MatrixXd stiffness_;
  Eigen::VectorXd tilt_, push_;
  double time_ = 0;
  std::vector<double> state_;  // the coefficients of eta, and their rates
};

}  // namespace slosh::reference

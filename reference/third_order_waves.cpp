#include "reference/third_order_waves.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "reference/natural_frequency.hpp"
#include "reference/require.hpp"

namespace slosh::reference {
namespace {

using Eigen::ArrayXd, Eigen::MatrixXd, Eigen::VectorXd;

constexpr int modes = 16, points = 2 * modes;  // of products of three no mode is aliased
constexpr double step_of_fastest = 0.3;        // [rad] of the last mode in one step
// The last modes would grow from rounding, as in nonlinear_potential_flow.cpp.
constexpr double filter_rate = 10;
constexpr int filter_power = 16;

struct State {
  VectorXd elevation, potential;  // of the modes 1 to `modes`

  State plus(double step, const State& rate) const {
    return {elevation + step * rate.elevation, potential + step * rate.potential};
  }
};

class Waves {
 public:
  explicit Waves(const ThirdOrderWaves& waves)
      : waves_(waves), k_(modes), g0_(modes), shape_(points, modes), slope_(points, modes) {
    const double length = waves.tank.length;
    for (int n = 0; n < modes; ++n) {
      k_[n] = (n + 1) * std::numbers::pi / length;
      g0_[n] = k_[n] * std::tanh(k_[n] * waves.tank.fill_depth);
      for (int j = 0; j < points; ++j) {
        const double phase = (n + 1) * std::numbers::pi * (j + 0.5) / points;
        shape_(j, n) = std::cos(phase);
        slope_(j, n) = -k_[n] * std::sin(phase);
      }
    }
    onto_modes_ = 2.0 / points * shape_.transpose();
    // x = -sum of 4 L / (n pi)^2 cos(n pi (x / L + 1/2)) over odd n
    along_ = VectorXd::Zero(modes);
    for (int n = 0; n < modes; n += 2) along_[n] = -4 / (length * k_[n] * k_[n]);
    decay_ = 2 * waves.kinematic_viscosity * k_.square();
    const ArrayXd order = ArrayXd::LinSpaced(modes, 1, modes) / modes;
    smoothing_ = filter_rate * std::sqrt(waves.tank.gravity / length) * order.pow(filter_power);
  }

  State start() const {
    State state{VectorXd::Zero(modes), -waves_.initial_velocity * along_};
    const auto& [mode, amplitude] = waves_.initial_wave;
    if (mode <= modes) state.elevation[mode - 1] = amplitude;
    return state;
  }

  double longest_step() const {
    return step_of_fastest / std::sqrt(waves_.tank.gravity * g0_.maxCoeff());
  }

  // The classical method of fourth order, then the smoothing.
  State after(const State& y, double t, double step, bool linear) const {
    const State a = rate(y, t, linear), b = rate(y.plus(step / 2, a), t + step / 2, linear),
                c = rate(y.plus(step / 2, b), t + step / 2, linear),
                d = rate(y.plus(step, c), t + step, linear);
    State next = y.plus(step / 6, a).plus(step / 3, b).plus(step / 3, c).plus(step / 6, d);
    const ArrayXd kept = (-step * (smoothing_ + decay_)).exp();
    next.elevation.array() *= kept;
    next.potential.array() *= kept;
    return next;
  }

  Eigen::RowVectorXd shape_at(double x) const {
    Eigen::RowVectorXd shape(modes);
    for (int n = 0; n < modes; ++n) shape[n] = mode_shape(waves_.tank, n + 1, x);
    return shape;
  }

 private:
  State rate(const State& y, double t, bool linear) const {
    const double push = waves_.acceleration ? waves_.acceleration(t) : 0;
    State rate{g0_.matrix().cwiseProduct(y.potential),
               -waves_.tank.gravity * y.elevation - push * along_};
    if (!linear) add_products(y, rate);
    return rate;
  }

  VectorXd normal(const VectorXd& values) const { return g0_ * (onto_modes_ * values).array(); }

  // The mean level needs no mode: a constant in eta_t is zero, one in psi_t moves nothing.
  void add_products(const State& y, State& rate) const {
    const ArrayXd eta = shape_ * y.elevation, eta_x = slope_ * y.elevation,
                  psi_x = slope_ * y.potential,
                  psi_xx = -(shape_ * (k_.square() * y.potential.array()).matrix()),
                  w = shape_ * (g0_ * y.potential.array()).matrix();
    const VectorXd inner = normal((eta * w).matrix());  // G0 eta G0 psi
    const ArrayXd inner_here = shape_ * inner;
    const ArrayXd w_xx_part = k_.square() * (onto_modes_ * (eta.square() * w).matrix()).array();
    rate.elevation += onto_modes_ * (-(eta_x * psi_x + eta * psi_xx)).matrix() - inner +
                      normal((eta.square() * psi_xx / 2 + eta * inner_here).matrix()) -
                      (w_xx_part / 2).matrix();
    rate.potential +=
        onto_modes_ *
        ((w.square() - psi_x.square()) / 2 - w * (eta * psi_xx + inner_here)).matrix();
  }

  const ThirdOrderWaves& waves_;
  ArrayXd k_, g0_, decay_, smoothing_;
  MatrixXd shape_, slope_, onto_modes_;
  VectorXd along_;
};

}  // namespace

ThirdOrderRecord third_order_waves(const ThirdOrderWaves& waves, const std::vector<double>& x,
                                   const std::vector<double>& times) {
  natural_frequency(waves.tank, 1);  // throws for an impossible tank
  const Waves of_tank(waves);
  MatrixXd shapes(x.size(), modes);
  for (std::size_t i = 0; i < x.size(); ++i)
    shapes.row(static_cast<Eigen::Index>(i)) = of_tank.shape_at(x[i]);
  ThirdOrderRecord record;
  record.linear.resize(x.size());
  record.beyond.resize(x.size());
  State linear = of_tank.start(), all = linear;
  double t = 0;
  for (const double time : times) {
    require(time >= t && std::isfinite(time), "third_order_waves", "time", time,
            "rising times from 0 s on");
    const int steps = static_cast<int>(std::ceil((time - t) / of_tank.longest_step()));
    const double step = steps > 0 ? (time - t) / steps : 0;
    for (int i = 0; i < steps; ++i, t += step) {
      linear = of_tank.after(linear, t, step, true);
      all = waves.linear_alone ? linear : of_tank.after(all, t, step, false);
    }
    t = time;
    const VectorXd here = shapes * linear.elevation, there = shapes * all.elevation;
    for (std::size_t i = 0; i < x.size(); ++i) {
      record.linear[i].push_back(here[static_cast<Eigen::Index>(i)]);
      record.beyond[i].push_back(there[static_cast<Eigen::Index>(i)] - record.linear[i].back());
    }
  }
  return record;
}

}  // namespace slosh::reference

#include "reference/third_order_waves.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "reference/natural_frequency.hpp"
#include "reference/require.hpp"

namespace slosh::reference {
namespace {

using Eigen::ArrayXd, Eigen::MatrixXd, Eigen::RowVectorXd, Eigen::VectorXd;

// The third harmonic of a wave is the mode at three quarters, of which (3/4)^16, a hundredth of the
// last mode's smoothing, is taken away.
constexpr int fewest_wave_modes = 16, most_wave_modes = 64, modes_of_wave = 4;
constexpr double step_of_fastest = 0.3;  // [rad] of the last mode in one step
constexpr double share_of_step = 1e-2;   // of the difference along the solution
// The last modes would grow from rounding, as in nonlinear_potential_flow.cpp.
constexpr double filter_rate = 10;
constexpr int filter_power = 16;

// The potential of the forces of a turn that linear theory leaves out, of numbers or arrays.
template <class X, class Z>
X turned(const ThirdOrderWaves::Turn& turn, const X& x, const Z& z) {
  return turn.spin * turn.spin / 2 *
             ((x - turn.axis_x) * (x - turn.axis_x) + (z - turn.axis_z) * (z - turn.axis_z)) +
         turn.tilt * z;
}

// Of the odd mode of this wave number in the line x.
double share_of_line(double k, double length) { return -4 / (length * k * k); }

struct State {
  VectorXd elevation, potential;  // of the modes 1 to `modes`

  State plus(double step, const State& rate) const {
    return {elevation + step * rate.elevation, potential + step * rate.potential};
  }
};

int count_of_modes(const ThirdOrderWaves& waves) {
  return std::clamp(modes_of_wave * waves.initial_wave.mode, fewest_wave_modes, most_wave_modes);
}

class Waves {
 public:
  const int modes;

  explicit Waves(const ThirdOrderWaves& waves)
      : modes(count_of_modes(waves)),
        waves_(waves),
        k_(modes),
        g0_(modes),
        shape_(2 * modes, modes),
        slope_(2 * modes, modes) {
    const int points = 2 * modes;  // of products of three no mode is aliased
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
    x_ = length * ((ArrayXd::LinSpaced(points, 0.5, points - 0.5)) / points - 0.5);
    onto_modes_ = 2.0 / points * shape_.transpose();
    // x = -sum of 4 L / (n pi)^2 cos(n pi (x / L + 1/2)) over odd n
    along_ = VectorXd::Zero(modes);
    for (int n = 0; n < modes; n += 2) along_[n] = share_of_line(k_[n], length);
    around_ = along_.array() * 2 * (k_ * waves.tank.fill_depth / 2).tanh() / k_;
    decay_ = 2 * waves.kinematic_viscosity * k_.square();
    const ArrayXd order = ArrayXd::LinSpaced(modes, 1, modes) / modes;
    smoothing_ = filter_rate * std::sqrt(waves.tank.gravity / length) * order.pow(filter_power);
  }

  State start() const {
    State state{VectorXd::Zero(modes),
                -waves_.initial_velocity * along_ - waves_.initial_spin * around_};
    const auto& [mode, amplitude] = waves_.initial_wave;
    if (modes_of_wave * mode <= most_wave_modes)
      state.elevation[mode - 1] = amplitude;
    else if (amplitude != 0)
      state.elevation.setConstant(std::nan(""));
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

  // phi0 and phi0_t, with the mean of either first, and the second derivative of the integral of
  // x eta dx. A central difference along the solution, whose terms are cubic at most.
  struct Level {
    VectorXd potential, rate;
    double push_of_mass;
  };
  Level level(const State& y, double t, bool linear) const {
    const State now = rate(y, t, linear);
    const double h = share_of_step * longest_step();
    const State before = y.plus(-h, now), after = y.plus(h, now);
    const VectorXd elevation_rate =
        (rate(after, t, linear).elevation - rate(before, t, linear).elevation) / (2 * h);
    Level found{
        level_potential(y, t, linear),
        (level_potential(after, t + h, linear) - level_potential(before, t - h, linear)) / (2 * h),
        waves_.tank.length / 2 * along_.dot(elevation_rate)};
    if (!linear) found.rate[0] += potential_products(surface(y, t), t).mean();
    return found;
  }

 private:
  // At the points of the surface.
  struct Surface {
    ArrayXd eta, eta_x, psi_x, psi_xx, w, inner;  // w: G0 psi, inner: G0 eta G0 psi
  };

  Surface surface(const State& y, double t) const {
    const VectorXd along = waves_.turn ? y.potential + waves_.turn(t).spin * around_ : y.potential;
    Surface at{shape_ * y.elevation,
               slope_ * y.elevation,
               slope_ * along,
               -(shape_ * (k_.square() * along.array()).matrix()),
               shape_ * (g0_ * y.potential.array()).matrix(),
               {}};
    at.inner = shape_ * normal((at.eta * at.w).matrix());
    return at;
  }

  VectorXd level_potential(const State& y, double t, bool linear) const {
    VectorXd found(modes + 1);
    found << 0, y.potential;
    if (linear) return found;
    const Surface at = surface(y, t);
    return found +
           with_mean((at.eta * (at.inner - at.w) + at.eta.square() * at.psi_xx / 2).matrix());
  }

  State rate(const State& y, double t, bool linear) const {
    const double push = waves_.acceleration ? waves_.acceleration(t) : 0;
    State rate{g0_.matrix().cwiseProduct(y.potential),
               -waves_.tank.gravity * y.elevation - push * along_};
    if (waves_.turn) rate.potential -= waves_.turn(t).spin_rate * around_;
    if (linear) return rate;
    const Surface at = surface(y, t);
    rate.elevation += elevation_products(at);
    rate.potential += onto_modes_ * potential_products(at, t);
    return rate;
  }

  VectorXd normal(const VectorXd& values) const { return g0_ * (onto_modes_ * values).array(); }

  VectorXd with_mean(const VectorXd& values) const {
    VectorXd found(modes + 1);
    found << values.mean(), onto_modes_ * values;
    return found;
  }

  // The mean level needs no mode: a constant in eta_t is zero, one in psi_t moves nothing.
  VectorXd elevation_products(const Surface& at) const {
    const ArrayXd w_xx_part =
        k_.square() * (onto_modes_ * (at.eta.square() * at.w).matrix()).array();
    return onto_modes_ * (-(at.eta_x * at.psi_x + at.eta * at.psi_xx)).matrix() -
           normal((at.eta * at.w).matrix()) +
           normal((at.eta.square() * at.psi_xx / 2 + at.eta * at.inner).matrix()) -
           (w_xx_part / 2).matrix();
  }

  VectorXd potential_products(const Surface& at, double t) const {
    ArrayXd sum = (at.w.square() - at.psi_x.square()) / 2 - at.w * (at.eta * at.psi_xx + at.inner);
    if (!waves_.turn) return sum;
    const ThirdOrderWaves::Turn turn = waves_.turn(t);
    return sum + turned(turn, x_, at.eta) - turn.spin_rate * at.eta * (x_ - turn.axis_x);
  }

  const ThirdOrderWaves& waves_;
  ArrayXd k_, g0_, x_, decay_, smoothing_;
  MatrixXd shape_, slope_, onto_modes_;
  VectorXd along_, around_;
};

std::vector<double> values_of(const RowVectorXd& row) {
  return {row.data(), row.data() + row.size()};
}

}  // namespace

// The shapes of the modes at a place under the surface, the mean's first.
struct ThirdOrderRecord::Below {
  RowVectorXd potential, along_x, along_z;
  double turn = 0, turn_x = 0, turn_z = 0;  // K and the flow of a turn
};

RowVectorXd ThirdOrderRecord::shape_at(double x) const {
  RowVectorXd shape(all_.elevation.rows());
  for (int n = 0; n < shape.size(); ++n) shape[n] = mode_shape(tank_, n + 1, x);
  return shape;
}

// 0 where the surface is below the place.
ThirdOrderRecord::Row ThirdOrderRecord::wet(double x, double z) const {
  return ((shape_at(x) * all_.elevation).array() >= z)
      .select(Row::Ones(force_.size()), Row::Zero(force_.size()));
}

ThirdOrderRecord::Below ThirdOrderRecord::below(double x, double z) const {
  const double height = std::max(0.0, z + tank_.fill_depth);
  const RowVectorXd shape = shape_at(x);
  const Eigen::Index modes = shape.size();
  Below at{RowVectorXd::Zero(modes + 1), RowVectorXd::Zero(modes + 1),
           RowVectorXd::Zero(modes + 1)};
  at.potential[0] = 1;
  for (int n = 1; n <= modes; ++n) {
    const double k = n * std::numbers::pi / tank_.length,
                 of_level = std::cosh(k * tank_.fill_depth);
    at.potential[n] = shape[n - 1] * std::cosh(k * height) / of_level;
    at.along_x[n] = -k * std::sin(k * (x + tank_.length / 2)) * std::cosh(k * height) / of_level;
    at.along_z[n] = k * shape[n - 1] * std::sinh(k * height) / of_level;
    if (n % 2 == 0) continue;
    const double part = 2 * share_of_line(k, tank_.length),
                 of_middle = std::cosh(k * tank_.fill_depth / 2),
                 from_middle = k * (height - tank_.fill_depth / 2);
    at.turn += part / k * shape[n - 1] * std::sinh(from_middle) / of_middle;
    at.turn_x -= part * std::sin(k * (x + tank_.length / 2)) * std::sinh(from_middle) / of_middle;
    at.turn_z += part * shape[n - 1] * (std::cosh(from_middle) / of_middle - 1);
  }
  return at;
}

std::vector<double> ThirdOrderRecord::linear_elevation(double x) const {
  return values_of(shape_at(x) * linear_.elevation);
}

std::vector<double> ThirdOrderRecord::elevation(double x) const {
  return values_of(shape_at(x) * (all_.elevation - linear_.elevation));
}

std::vector<double> ThirdOrderRecord::velocity(const RowVectorXd& shape, double of_turn,
                                               const Row& wet) const {
  Row found = wet * (shape * all_.potential).array() - (shape * linear_.potential).array();
  for (Eigen::Index i = 0; i < static_cast<Eigen::Index>(turn_.size()); ++i)
    found[i] -= (1 - wet[i]) * turn_[static_cast<std::size_t>(i)].spin * of_turn;
  return values_of(found.matrix());
}

std::vector<double> ThirdOrderRecord::velocity_x(double x, double z) const {
  const Below at = below(x, z);
  return velocity(at.along_x, at.turn_x, wet(x, z));
}

std::vector<double> ThirdOrderRecord::velocity_z(double x, double z) const {
  const Below at = below(x, z);
  return velocity(at.along_z, at.turn_z, wet(x, z));
}

ThirdOrderRecord::Row ThirdOrderRecord::pressure_at(double x, double z, const Row& wet) const {
  const Below at = below(x, z);
  Row u = (at.along_x * all_.potential).array(), w = (at.along_z * all_.potential).array(),
      still = tank_.gravity * z + x * acceleration_, turn = Row::Zero(force_.size());
  for (Eigen::Index i = 0; i < static_cast<Eigen::Index>(turn_.size()); ++i) {
    const ThirdOrderWaves::Turn& now = turn_[static_cast<std::size_t>(i)];
    u[i] += now.spin * at.turn_x;
    w[i] += now.spin * at.turn_z;
    still[i] += now.spin_rate * (at.turn - (x + now.axis_x) * z);
    turn[i] = turned(now, x, z);
  }
  return tank_.density * ((at.potential * linear_.rate).array() + still -
                          wet * ((at.potential * all_.rate).array() + still +
                                 (u.square() + w.square()) / 2 - turn));
}

std::vector<double> ThirdOrderRecord::pressure(double x, double z) const {
  return values_of(pressure_at(x, z, wet(x, z)).matrix());
}

std::vector<double> ThirdOrderRecord::force_x() const { return values_of(force_.matrix()); }

// Up to the still surface by the midpoint rule, also where it is dry: from there to the surface the
// pressure falls on a line.
std::vector<double> ThirdOrderRecord::moment(double x, double z) const {
  constexpr int places = 32;
  const double half = tank_.length / 2, height = tank_.fill_depth / places,
               width = tank_.length / places;
  const Row everywhere = Row::Ones(force_.size());
  Row sum = Row::Zero(force_.size());
  const auto add = [&](double lever, double at_x, double at_z) {
    sum += lever * pressure_at(at_x, at_z, everywhere);
  };
  for (int i = 0; i < places; ++i) {
    const double at_z = -(i + 0.5) * height, at_x = -half + (i + 0.5) * width;
    add(height * (at_z - z), -half, at_z);
    add(-height * (at_z - z), half, at_z);
    add(-width * (at_x - x), at_x, -tank_.fill_depth);
  }
  const Row left = (shape_at(-half) * all_.elevation).array(),
            right = (shape_at(half) * all_.elevation).array();
  const auto above = [&](const Row& eta) -> Row {
    return tank_.density * tank_.gravity / 2 * eta.square() * (eta / 3 - z);
  };
  return values_of((sum + above(left) - above(right)).matrix());
}

ThirdOrderRecord third_order_waves(const ThirdOrderWaves& waves, const std::vector<double>& times) {
  natural_frequency(waves.tank, 1);  // throws for an impossible tank
  const Waves of_tank(waves);
  ThirdOrderRecord record;
  const auto count = static_cast<Eigen::Index>(times.size());
  record.tank_ = waves.tank;
  record.acceleration_ = record.force_ = ThirdOrderRecord::Row::Zero(count);
  for (ThirdOrderRecord::Modes* one : {&record.linear_, &record.all_})
    *one = {MatrixXd(of_tank.modes, count), MatrixXd(of_tank.modes + 1, count),
            MatrixXd(of_tank.modes + 1, count)};
  State linear = of_tank.start(), all = linear;
  double t = 0;
  for (Eigen::Index i = 0; i < count; ++i) {
    const double time = times[static_cast<std::size_t>(i)];
    require(time >= t && std::isfinite(time), "third_order_waves", "time", time,
            "rising times from 0 s on");
    const int steps = static_cast<int>(std::ceil((time - t) / of_tank.longest_step()));
    const double step = steps > 0 ? (time - t) / steps : 0;
    for (int n = 0; n < steps; ++n, t += step) {
      linear = of_tank.after(linear, t, step, true);
      all = waves.linear_alone ? linear : of_tank.after(all, t, step, false);
    }
    t = time;
    if (waves.acceleration) record.acceleration_[i] = waves.acceleration(t);
    if (waves.turn) record.turn_.push_back(waves.turn(t));
    for (const bool is_linear : {true, false}) {
      const State& now = is_linear ? linear : all;
      const Waves::Level level = of_tank.level(now, t, is_linear || waves.linear_alone);
      ThirdOrderRecord::Modes& kept = is_linear ? record.linear_ : record.all_;
      kept.elevation.col(i) = now.elevation;
      kept.potential.col(i) = level.potential;
      kept.rate.col(i) = level.rate;
      record.force_[i] += (is_linear ? 1 : -1) * waves.tank.density * level.push_of_mass;
    }
  }
  return record;
}

}  // namespace slosh::reference

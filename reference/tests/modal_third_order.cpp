#include "reference/tests/modal_third_order.hpp"

#include <algorithm>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cmath>
#include <numbers>

#include "reference/natural_frequency.hpp"
#include "reference/require.hpp"

namespace slosh::reference {
namespace {

namespace odeint = boost::numeric::odeint;

constexpr auto where = "run_modal_third_order";
constexpr double step_tolerance = 1e-13;  // [m], [m/s]

constexpr double longest_step = 0.02;  // in first natural periods, so that no motion is missed

// third_order_waves_test.cpp measures how the error grows with the amplitude. In shallower liquid
// the second and third modes resonate with the first. At the critical depth
// d(frequency)/d(amplitude^2) vanishes, which is all that the theory adds near resonance.
constexpr double greatest_amplitude = 0.08, greatest_share = 0.5;
constexpr double shallowest = 0.2, critical_depth = 0.3368012, too_near = 0.02;

using State = std::vector<double>;  // b1, b2, b3 and their rates

struct System {
  std::array<double, 10> d;
  std::array<double, 3> stiffness, coupling;  // s_i^2; F_i by X''
  const std::function<double(double)>& acceleration;

  explicit System(const ModalSloshing& sloshing)
      : d(modal_coefficients(sloshing.tank)), acceleration(sloshing.acceleration) {
    const Tank& tank = sloshing.tank;
    for (int i = 1; i <= 3; ++i) {
      const double omega = natural_frequency(tank, i);
      stiffness[i - 1] = omega * omega;
      coupling[i - 1] = i % 2 == 1 ? omega * omega / tank.gravity * 4 * tank.length /
                                         (i * i * std::numbers::pi * std::numbers::pi)
                                   : 0;
    }
  }

  void operator()(const State& y, State& rate, double t) const {
    const double b1 = y[0], b2 = y[1], b3 = y[2], v1 = y[3], v2 = y[4], v3 = y[5];
    const double push = acceleration ? acceleration(t) : 0;
    require(std::isfinite(push), where, fmt::format("acceleration at {} s", t), push,
            "a finite acceleration, m/s2");
    const auto& [d1, d2, d3, d4, d5, d6, d7, d8, d9, d10] = d;
    // The first two equations are linear in b1'' and b2'':
    //   m11 b1'' + m12 b2'' = r1,  m21 b1'' + b2'' = r2.
    const double m11 = 1 + d1 * b2 + d2 * b1 * b1, m12 = d3 * b1, m21 = d4 * b1;
    const double r1 = coupling[0] * push - stiffness[0] * b1 - d1 * v1 * v2 - d2 * v1 * v1 * b1;
    const double r2 = -stiffness[1] * b2 - d5 * v1 * v1;
    const double a1 = (r1 - m12 * r2) / (m11 - m12 * m21), a2 = r2 - m21 * a1;
    const double a3 = coupling[2] * push - stiffness[2] * b3 - d6 * a1 * b2 - d7 * a1 * b1 * b1 -
                      d8 * a2 * b1 - d9 * v1 * v2 - d10 * v1 * v1 * b1;
    rate = {v1, v2, v3, a1, a2, a3};
  }
};

std::string why_out_of_range(const ModalSloshing& sloshing, const State& y, double greatest_b1) {
  const auto& [length, depth, gravity, density] = sloshing.tank;
  const double b1 = y[0], b2 = y[1], b3 = y[2];
  if (!(depth / length >= shallowest)) {
    return fmt::format("the liquid is shallow: depth/length = {:.4g}, the theory asks for {}",
                       depth / length, shallowest);
  }
  if (!(std::abs(depth / length - critical_depth) >= too_near)) {
    return fmt::format("depth/length = {:.4g} is near the critical {:.4g}", depth / length,
                       critical_depth);
  }
  if (!(std::abs(b1) <= greatest_amplitude * length)) {
    return fmt::format("the wave is too high: b1 = {:.3g} m in a tank of {:.3g} m", b1, length);
  }
  if (!(std::max(std::abs(b2), std::abs(b3)) <= greatest_share * greatest_b1)) {
    return fmt::format(
        "the first mode does not dominate: b1 up to {:.3g}, b2 = {:.3g}, b3 = {:.3g} m",
        greatest_b1, b2, b3);
  }
  const double left = b1 + b2 + b3, right = -b1 + b2 - b3;
  if (!(std::max(left, right) < sloshing.roof)) return "the liquid reaches the roof";
  if (!(std::min(left, right) > -depth)) return "the bottom falls dry";
  return "";
}

}  // namespace

std::array<double, 10> modal_coefficients(const Tank& tank) {
  natural_frequency(tank, 1);  // throws for an impossible length or depth
  const double k = std::numbers::pi / tank.length;
  const double T1 = std::tanh(k * tank.fill_depth), T2 = std::tanh(2 * k * tank.fill_depth),
               T3 = std::tanh(3 * k * tank.fill_depth);
  return {k * (T1 * T1 + 1) / (2 * T1),
          k * k * (2 - T1 * T2) / (4 * T1 * T2),
          k * (T1 * T2 - 1) / (2 * T2),
          k * (T1 * T2 - 1) / T1,
          k * (T1 * T1 * T2 - 2 * T1 - T2) / (2 * T1 * T1),
          3 * k * (T1 * T3 - 1) / (2 * T1),
          -3 * k * k * (T1 * T2 + 3 * T2 * T3 - 4) / (8 * T1 * T2),
          3 * k * (T2 * T3 - 1) / (2 * T2),
          3 * k * (T1 * T2 * T3 - T1 - T2 - T3) / (2 * T1 * T2),
          -3 * k * k * (T1 * T1 * T2 + 4 * T1 * T2 * T3 - 4 * T1 - 2 * T3) / (4 * T1 * T1 * T2)};
}

std::vector<double> ModalRecord::elevation(double x) const {
  require(std::abs(x) <= (0.5 + rounding) * length, where, "x", x,
          fmt::format("a position within {} m of the tank's centre", length / 2));
  const double angle = std::numbers::pi * (x / length + 0.5);
  std::vector<double> series;
  series.reserve(modes.size());
  for (const auto& [b1, b2, b3] : modes) {
    series.push_back(b1 * std::cos(angle) + b2 * std::cos(2 * angle) + b3 * std::cos(3 * angle));
  }
  return series;
}

SecondMode::SecondMode(const Tank& tank, double amplitude)
    : s1(natural_frequency(tank, 1)), s2(natural_frequency(tank, 2)) {
  const auto d = modal_coefficients(tank);
  const double scale = amplitude * amplitude * s1 * s1;
  constant = scale * (d[3] - d[4]) / (2 * s2 * s2);
  at_twice = scale * (d[3] + d[4]) / (2 * (s2 * s2 - 4 * s1 * s1));
}

std::vector<double> SecondMode::of_released_wave(const std::vector<double>& times) const {
  std::vector<double> series;
  for (const double t : times)
    series.push_back(constant * (1 - std::cos(s2 * t)) +
                     at_twice * (std::cos(2 * s1 * t) - std::cos(s2 * t)));
  return series;
}

ModalRecord run_modal_third_order(const ModalSloshing& sloshing, const std::vector<double>& times) {
  require(sloshing.roof > 0, where, "roof", sloshing.roof, "a height > 0 m above the surface");
  require(std::isfinite(sloshing.initial_velocity), where, "initial velocity",
          sloshing.initial_velocity, "a finite velocity, m/s");
  const System system(sloshing);
  State y(6, 0.0);
  for (int i = 0; i < 3; ++i) {
    y[i] = sloshing.initial_modes[i];
    require(std::isfinite(y[i]), where, "initial mode", y[i], "a finite height, m");
    // At a sudden start b_i' jumps by the integral of F_i.
    if (sloshing.start == Start::earth) y[3 + i] = system.coupling[i] * sloshing.initial_velocity;
  }

  ModalRecord record;
  record.length = sloshing.tank.length;
  const double period = 2 * std::numbers::pi / natural_frequency(sloshing.tank, 1);
  double t = 0;
  // The first mode's rate counts too: at a start from rest the others move as soon as it does.
  double greatest_b1 = 0;
  const auto watch = [&] {
    const double rate = std::abs(y[3]) * period / (2 * std::numbers::pi);
    greatest_b1 = std::max({greatest_b1, std::abs(y[0]), rate});
    record.left_range_because = why_out_of_range(sloshing, y, greatest_b1);
    if (record.left_range_because.empty()) record.valid_until = t;
  };
  watch();
  auto stepper =
      odeint::make_controlled<odeint::runge_kutta_fehlberg78<State>>(step_tolerance, 0.0);
  double step = longest_step * period;
  for (const double time : times) {
    require(time >= t && std::isfinite(time), where, "time", time, "rising times from 0 s on");
    while (t < time && record.left_range_because.empty()) {
      double tried = std::min(step, time - t);
      const bool to_the_end = tried < step;
      if (stepper.try_step(system, y, t, tried) == odeint::success) {
        if (to_the_end) t = time;
        if (!to_the_end) step = std::min(tried, longest_step * period);
        watch();
      } else {
        step = tried;
      }
    }
    if (!record.left_range_because.empty()) break;
    record.times.push_back(t);
    record.modes.push_back({y[0], y[1], y[2]});
  }
  return record;
}

}  // namespace slosh::reference

// What the tests of the nonlinear potential flow and of its modal theory share.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "reference/modal_third_order.hpp"
#include "reference/nonlinear_potential_flow.hpp"
#include "reference/tests/li_tank.hpp"

namespace slosh::reference {

inline std::vector<double> instants_up_to(double last, double step) {
  std::vector<double> times;
  for (int i = 0; i * step < last + step / 2; ++i) times.push_back(i * step);
  return times;
}

// q(t) = sin(omega t) (1 - exp(-(t/rise)^8)) and its first two derivatives: it excites no mode that
// the forcing itself does not.
struct SmoothStart {
  double omega, rise;

  struct Value {
    double q, rate, acceleration;
  };
  Value at(double t) const {
    const double s = std::pow(t / rise, 8), fallen = std::exp(-s);
    const double s1 = t > 0 ? 8 * s / t : 0, s2 = t > 0 ? 56 * s / (t * t) : 0;
    const double ramp = 1 - fallen, ramp1 = s1 * fallen, ramp2 = (s2 - s1 * s1) * fallen;
    const double sine = std::sin(omega * t), cosine = std::cos(omega * t);
    return {ramp * sine, ramp1 * sine + ramp * omega * cosine,
            ramp2 * sine + 2 * ramp1 * omega * cosine - ramp * omega * omega * sine};
  }
};

inline TankMotion smooth_surge(double amplitude, SmoothStart start) {
  TankMotion motion;
  motion.surge_velocity = [=](double t) { return amplitude * start.at(t).rate; };
  motion.surge_acceleration = [=](double t) { return amplitude * start.at(t).acceleration; };
  return motion;
}

inline TankMotion smooth_roll(double amplitude, SmoothStart start) {
  TankMotion motion;
  motion.angle = [=](double t) { return amplitude * start.at(t).q; };
  motion.rate = [=](double t) { return amplitude * start.at(t).rate; };
  motion.roll_acceleration = [=](double t) { return amplitude * start.at(t).acceleration; };
  return motion;
}

inline NonlinearSloshing standing_wave(const Tank& tank, double amplitude) {
  return {.tank = tank, .initial_elevation = [=](double x) {
            return amplitude * std::cos(std::numbers::pi * (x / tank.length + 0.5));
          }};
}

// b2 to the second order (the second equation of modal_third_order.hpp) of a wave whose first mode
// is b1 = amplitude cos(s1 t):
// constant + at_twice cos(2 s1 t), and what swings freely, as cos(s2 t), beside that.
struct SecondMode {
  double s1, s2;  // [rad/s], of the first two modes
  double constant, at_twice;

  SecondMode(const Tank& tank, double amplitude)
      : s1(natural_frequency(tank, 1)), s2(natural_frequency(tank, 2)) {
    const auto d = modal_coefficients(tank);
    const double scale = amplitude * amplitude * s1 * s1;
    constant = scale * (d[3] - d[4]) / (2 * s2 * s2);
    at_twice = scale * (d[3] + d[4]) / (2 * (s2 * s2 - 4 * s1 * s1));
  }

  // At the start of a wave of lasting form, which has no free part.
  double of_lasting_form() const { return constant + at_twice; }

  // Of a wave released at rest with b2 = 0.
  std::vector<double> of_released_wave(const std::vector<double>& times) const {
    std::vector<double> series;
    for (const double t : times)
      series.push_back(constant * (1 - std::cos(s2 * t)) +
                       at_twice * (std::cos(2 * s1 * t) - std::cos(s2 * t)));
    return series;
  }
};

// Tadjbakhsh & Keller (1960): omega/omega_1 = 1 + (k A)^2 (9 T^-4 - 12 T^-2 - 3 - 2 T^2)/64,
// T = tanh kh, for a wave of lasting form: the factor of (k A)^2.
inline double frequency_shift_of_lasting_wave(const Tank& tank) {
  const double T = std::tanh(std::numbers::pi / tank.length * tank.fill_depth);
  return (9 * std::pow(T, -4) - 12 * std::pow(T, -2) - 3 - 2 * T * T) / 64;
}

// Midpoints of equal parts of the tank, on which the modes below the count are orthogonal.
inline std::vector<double> midpoints(double length, int count) {
  std::vector<double> x;
  for (int i = 0; i < count; ++i) x.push_back(length * ((i + 0.5) / count - 0.5));
  return x;
}

// The amplitude of cos(n pi (x/length + 1/2)) at each time, from elevations at the midpoints.
inline std::vector<double> mode(const NonlinearRecord& record, int n) {
  const auto count = record.elevation.size();
  std::vector<double> series(record.times.size());
  for (std::size_t i = 0; i < count; ++i) {
    const double shape = 2.0 / count * std::cos(n * std::numbers::pi * (i + 0.5) / count);
    for (std::size_t j = 0; j < series.size(); ++j) series[j] += shape * record.elevation[i][j];
  }
  return series;
}

inline double largest(const std::vector<double>& values) {
  double largest = 0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  return largest;
}

// Infinite where the series differ in length, so that a run cut short never passes.
inline double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.size() != b.size() || a.empty()) return std::numeric_limits<double>::infinity();
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

}  // namespace slosh::reference

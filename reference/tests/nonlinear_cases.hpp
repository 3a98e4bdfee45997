// Motions, waves and measures that the tests of the nonlinear potential flow share.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "reference/potential_flow/nonlinear_potential_flow.hpp"
#include "reference/tests/paper_tanks.hpp"

namespace slosh::reference {

inline std::vector<double> instants_up_to(double last, double step) {
  std::vector<double> times;
  for (int i = 0; i * step < last + step / 2; ++i) times.push_back(i * step);
  return times;
}

// q(t) = sin(omega t) (1 - exp(-(t/rise)^8)) and its first two derivatives. The start is so smooth
// that it excites no other modes than the forcing itself does.
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

// X(t) = amplitude cos(omega t): a tank at rest that has its full acceleration at once.
inline TankMotion cosine_surge(double amplitude, double omega) {
  TankMotion motion;
  motion.surge_velocity = [=](double t) { return -amplitude * omega * std::sin(omega * t); };
  motion.surge_acceleration = [=](double t) {
    return -amplitude * omega * omega * std::cos(omega * t);
  };
  return motion;
}

// The tank and the period of Faltinsen et al. 2000 (J. Fluid Mech. 407, 201-234) that the example
// sloshing_tank_horizontal of PySPH computes; its amplitude is 0.032 m.
inline constexpr Tank faltinsen_tank{
    .length = 1.73, .fill_depth = 0.6, .gravity = 9.81, .density = 1000};
inline constexpr double faltinsen_frequency = 2 * std::numbers::pi / 1.3;  // [rad/s]

inline NonlinearSloshing standing_wave(const Tank& tank, double amplitude) {
  return {.tank = tank, .initial_elevation = [=](double x) {
            return amplitude * std::cos(std::numbers::pi * (x / tank.length + 0.5));
          }};
}

// Tadjbakhsh & Keller (1960): omega/omega_1 = 1 + (k A)^2 (9 T^-4 - 12 T^-2 - 3 - 2 T^2)/64,
// T = tanh kh, for a wave of permanent form. Returns the factor of (k A)^2.
inline double frequency_shift_of_lasting_wave(const Tank& tank) {
  const double T = std::tanh(std::numbers::pi / tank.length * tank.fill_depth);
  return (9 * std::pow(T, -4) - 12 * std::pow(T, -2) - 3 - 2 * T * T) / 64;
}

// Returns the midpoints of `count` equal parts of the tank, on which the modes below the count are
// orthogonal.
inline std::vector<double> midpoints(double length, int count) {
  std::vector<double> x;
  for (int i = 0; i < count; ++i) x.push_back(length * ((i + 0.5) / count - 0.5));
  return x;
}

// Returns the amplitude of cos(n pi (x/length + 1/2)) at each time, from elevations at the
// midpoints.
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

// Returns infinity where the series differ in length, so that a run that ends early never passes.
inline double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.size() != b.size() || a.empty()) return std::numeric_limits<double>::infinity();
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

}  // namespace slosh::reference

// Linear potential flow in a rectangular tank moving horizontally, by its antisymmetric natural
// modes (Li et al. 2010, eqs 16-20 corrected; Faltinsen 1978; Liu & Lin 2008). x from the tank's
// CENTRE in the tank's frame, z up from the still surface, a = length/2:
//   lambda_n = (2n+1) pi / length,  omega_n^2 = g lambda_n tanh(lambda_n h),
//   c_n = 2 (-1)^n / (a lambda_n^2),
//   eta(x,t) = sum_n eta_n(t) sin(lambda_n x),
//   eta_n'' + omega_n^2 eta_n = -c_n lambda_n tanh(lambda_n h) X''(t).
// Valid for waves small against the depth, the wave length and the distance from resonance.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace slosh::reference {

struct Tank {
  double length, fill_depth;  // [m]
  double gravity;             // [m/s2]
  double density;             // [kg/m3]
};

// The gas between the still surface and the roof, for the two-layer dispersion relation
// omega^2 = g k (rho_w - rho_a) / (rho_w coth kh + rho_a coth k(H-h)).
struct Gas {
  double density;  // [kg/m3]
  double height;   // [m], roof above the still surface
};

enum class Start { earth, tank };

// X(t) = amplitude sin(angular_frequency t): the closed form is used, with its limit at resonance.
struct SineSurge {
  double amplitude;          // [m]
  double angular_frequency;  // [rad/s]
};

// Any motion: X'(0) and X''(t), integrated by Duhamel's integral, exact for an X'' that is linear
// between the sample times 0, step, 2 step, ...
struct AnySurge {
  double initial_velocity;
  std::function<double(double)> acceleration;
  double duration;  // [s]
  double step;      // [s]
};

// Natural angular frequency [rad/s] of the m-th mode of the tank, m = 1, 2, ... (k = m pi / length;
// the odd ones are those that surge excites). With a gas: two-layer theory.
double natural_frequency(const Tank& tank, int m);
double natural_frequency(const Tank& tank, const Gas& gas, int m);

// Positions and times outside the liquid at rest, or outside the motion's duration, and NaN throw
// std::invalid_argument, as impossible tanks, motions and numbers of modes do on construction. Take
// 500 modes or more for an elevation; linear_surge.cpp has the figures.
class LinearSurge {
 public:
  LinearSurge(const Tank& tank, Start start, const SineSurge& motion, int modes);
  LinearSurge(const Tank& tank, Start start, const AnySurge& motion, int modes);
  // The same with the frequencies (not the couplings) of the two-layer theory.
  LinearSurge(const Tank& tank, const Gas& gas, Start start, const SineSurge& motion, int modes);
  LinearSurge(const Tank& tank, const Gas& gas, Start start, const AnySurge& motion, int modes);
  ~LinearSurge();
  LinearSurge(LinearSurge&&) noexcept;

  double elevation(double x, double t) const;  // [m]
  std::vector<double> elevation(double x, std::span<const double> times) const;
  struct Velocity {
    double x, z;  // [m/s], relative to the tank
  };
  Velocity velocity(double x, double z, double t) const;
  double pressure(double x, double z, double t) const;  // gauge [Pa], hydrostatic part included
  double horizontal_force(double t) const;  // of the liquid on the tank, per metre of width [N/m]

 private:
  struct Modes;
  std::unique_ptr<const Modes> modes_;
};

}  // namespace slosh::reference

// How a mode (tank_mode.hpp) responds to the tank's motion: in closed form to a sine surge, by
// Duhamel's integral to any motion.
#pragma once

#include <cstddef>
#include <functional>
#include <string_view>
#include <vector>

#include "reference/tank_mode.hpp"

namespace slosh::reference {

// Returns the mode's state at t [s] >= 0 under X(t) = b sin(omega t + phi). With
// F = coupling b omega^2, delta = omega_n - omega, sigma = omega_n + omega and sinc(x) = sin(x)/x,
// sinc(0) = 1:
//   eta_n   = eta_n'(0)/omega_n sin(omega_n t)
//             + F cos(phi)/(omega_n sigma) [sin(omega t) - omega t cos(sigma t/2) sinc(delta t/2)]
//             + F sin(phi)/sigma t sin(sigma t/2) sinc(delta t/2)
//   eta_n'  = eta_n'(0) cos(omega_n t)
//             + F cos(phi)/sigma omega t sin(sigma t/2) sinc(delta t/2)
//             + F sin(phi)/sigma [sigma t/2 cos(sigma t/2) sinc(delta t/2)
//                                 + sin(sigma t/2) cos(delta t/2)]
//   eta_n'' = F sin(omega t + phi) - omega_n^2 eta_n
// For phi = 0 this equals the usual P sin(omega t) + (eta_n'(0) - P omega)/omega_n sin(omega_n t)
// with P = F/(omega_n^2 - omega^2), and the part of sin(phi) is P (cos(omega t) - cos(omega_n t)).
// The difference of two sines or cosines is written as a product, which removes the small divisor:
// nothing cancels near resonance, and omega = omega_n gives growing waves, of the first part
//   F cos(phi)/(2 omega^2) [sin(omega t) - omega t cos(omega t)].
ModeState forced_mode(const TankMode& mode, const SineSurge& motion, double t);

// What all modes have in common at a time: the motion's own sines and cosines.
struct SineInstant {
  SineInstant(const SineSurge& motion, double t);

  double time, amplitude, angular_frequency;
  double phase_cosine, phase_sine;  // of phi
  double cosine, sine;              // of omega t/2
  double phased_sine;               // of omega t + phi
};

ModeState forced_mode(const TankMode& mode, const SineInstant& now);

// The tank's displacement [m] or angle [rad] q(t), given by its second derivative at 0, step,
// 2 step, ..., or at the knots between which that is linear.
struct SampledMotion {
  std::string_view solution;  // the name that an error message starts with
  std::function<double(double)> acceleration;
  double duration, step;           // [s]
  std::vector<double> knots = {};  // [s] rising from 0 to the duration; none: the steps
};

// The modes under any motion q(t). Duhamel's integral is exact for a q'' that is linear between its
// samples: over an interval of length s with -coupling q'' = f0 + f1 s and w = omega_n,
//   eta(s)  = eta0 cos(w s) + eta0'/w sin(w s) + f0 (1 - cos(w s))/w^2 + f1 (s - sin(w s)/w)/w^2
//   eta'(s) = -w eta0 sin(w s) + eta0' cos(w s) + f0 sin(w s)/w + f1 (1 - cos(w s))/w^2.
// For a smooth q'' of angular frequency omega the relative error is (omega step)^2/12.
class DuhamelModes {
 public:
  // Samples q'' at the knots, or at 0, step, 2 step, ... and at the end, and stores every mode's
  // state there, 16 bytes for each mode and sample. Throws std::invalid_argument for a step or
  // duration that is not positive and finite, a step longer than the duration, knots that do not
  // rise from 0 to the duration, or an acceleration that is not finite.
  DuhamelModes(std::vector<TankMode> modes, const SampledMotion& motion);

  double duration() const { return times_.back(); }
  // Returns the interpolated q''(t) for 0 <= t <= duration.
  double acceleration(double t) const;
  // Returns the state of the n-th mode given, n = 0, 1, ..., for 0 <= t <= duration.
  ModeState state(std::size_t n, double t) const;

 private:
  struct Node {
    double elevation, rate;
  };

  std::size_t interval(double t) const;
  double slope(std::size_t i) const;

  std::vector<TankMode> modes_;
  std::vector<double> times_, acceleration_;
  std::vector<Node> nodes_;  // sample by sample, each with all modes
};

}  // namespace slosh::reference

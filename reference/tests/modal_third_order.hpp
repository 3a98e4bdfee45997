// The third-order modal system of a surging tank with one dominant mode, against which the tests
// compare the nonlinear potential flow. x is measured from the tank's CENTRE; with k = pi/length,
// T_i = tanh(i k h) and s_i^2 = g i k T_i:
//   b1'' + s1^2 b1 + d1 (b1'' b2 + b1' b2') + d2 (b1'' b1^2 + b1'^2 b1) + d3 b2'' b1 = F1
//   b2'' + s2^2 b2 + d4 b1'' b1 + d5 b1'^2 = 0
//   b3'' + s3^2 b3 + d6 b1'' b2 + d7 b1'' b1^2 + d8 b2'' b1 + d9 b1' b2' + d10 b1'^2 b1 = F3
//   F_i = i k T_i (4 length/(i^2 pi^2)) X'',  eta = sum b_i cos(i k (x + length/2)).
// b1 is of order e, b2 of e^2 and b3 of e^3; terms of order e^4 are left out (Faltinsen,
// Rognebakke, Lukovsky & Timokha, J. Fluid Mech. 407, 2000; the coefficients are derived anew and
// checked against the nonlinear potential flow). The modes above the third, which surge also
// excites, are left out: near the walls they add about a tenth of the tank's length times X''/g.
// The system is valid for moderate waves near the first resonance, in liquid that is not shallow
// and whose depth is not near 0.3368 length, where to this order the frequency does not depend on
// the amplitude.
#pragma once

#include <array>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "reference/tank.hpp"

namespace slosh::reference {

// Returns d1 to d10 of a tank, where element i - 1 is d_i: d2, d7 and d10 in [1/m2], the others in
// [1/m].
std::array<double, 10> modal_coefficients(const Tank& tank);

struct ModalSloshing {
  Tank tank;
  double roof = std::numeric_limits<double>::infinity();  // [m] above the still surface
  double initial_velocity = 0;                            // X'(0) [m/s]
  std::function<double(double)> acceleration = {};        // X'' [m/s2]; empty for a tank at rest
  Start start = Start::earth;
  std::array<double, 3> initial_modes{};  // b_i(0) [m]
};

// Series at the times up to `valid_until`.
struct ModalRecord {
  std::vector<double> times;                 // [s]
  std::vector<std::array<double, 3>> modes;  // b1, b2, b3 [m]
  double length;                             // of the tank [m]
  double valid_until = 0;                    // [s]
  std::string left_range_because;            // empty where the run reached its end

  std::vector<double> elevation(double x) const;  // [m], |x| <= length/2
};

// Solves the system at ascending times from 0 s. The record ends where |b1| exceeds 0.08 length,
// where |b2| or |b3| exceeds half of the largest |b1| so far, and where the wave at a wall reaches
// the roof or the bottom. It is empty for a depth below 0.2 length or within 0.02 length of 0.3368
// length. Throws std::invalid_argument for an impossible tank, motion, initial mode or time.
ModalRecord run_modal_third_order(const ModalSloshing& sloshing, const std::vector<double>& times);

// b2 to second order (the second equation) of a wave whose first mode is b1 = amplitude cos(s1 t):
// constant + at_twice cos(2 s1 t), plus a free oscillation cos(s2 t).
struct SecondMode {
  double s1, s2;  // [rad/s], of the first two modes
  double constant, at_twice;

  SecondMode(const Tank& tank, double amplitude);

  // Returns b2 at the start of a wave of permanent form, which has no free oscillation.
  double of_lasting_form() const { return constant + at_twice; }

  // Returns the series of b2 in a wave released at rest with b2 = 0.
  std::vector<double> of_released_wave(const std::vector<double>& times) const;
};

}  // namespace slosh::reference

// The third-order modal system of a surging tank with one dominant mode. x from the tank's CENTRE,
// basis cos(i k (x + length/2)), k = pi/length, T_i = tanh(i k h), s_i^2 = g i k T_i:
//   b1'' + s1^2 b1 + d1 (b1'' b2 + b1' b2') + d2 (b1'' b1^2 + b1'^2 b1) + d3 b2'' b1 = F1
//   b2'' + s2^2 b2 + d4 b1'' b1 + d5 b1'^2 = 0
//   b3'' + s3^2 b3 + d6 b1'' b2 + d7 b1'' b1^2 + d8 b2'' b1 + d9 b1' b2' + d10 b1'^2 b1 = F3
//   F_i = i k T_i (4 length/(i^2 pi^2)) X'',  eta = sum b_i cos(i k (x + length/2)),
// where b1 is of the order e, b2 of e^2 and b3 of e^3, and the terms of the order e^4 are left out
// (Faltinsen, Rognebakke, Lukovsky & Timokha, J. Fluid Mech. 407, 2000; the coefficients are
// derived anew and checked against the nonlinear potential flow). The modes above the third, which
// surge excites too, are left out: near the walls they add a share of X''/g of the order of a tenth
// of the tank's length.
// Valid for moderate waves near the first resonance in liquid neither shallow nor near the depth
// 0.3368 length, where the frequency ceases to depend on the amplitude at this order.
#pragma once

#include <array>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "reference/linear_surge.hpp"

namespace slosh::reference {

// d1 to d10 of a tank, [1/m] or, d2, d7 and d10, [1/m2]; d[i - 1] is d_i.
std::array<double, 10> modal_coefficients(const Tank& tank);

struct ModalSloshing {
  Tank tank;
  double roof = std::numeric_limits<double>::infinity();  // [m] above the still surface
  double initial_velocity = 0;                            // X'(0) [m/s]
  std::function<double(double)> acceleration = {};        // X'' [m/s2]; empty: the tank stands
  Start start = Start::earth;
  std::array<double, 3> initial_modes{};  // b_i(0) [m]
};

// Series at those of the times up to `valid_until`.
struct ModalRecord {
  std::vector<double> times;                 // [s]
  std::vector<std::array<double, 3>> modes;  // b1, b2, b3 [m]
  double length;                             // of the tank [m]
  double valid_until = 0;                    // [s]
  std::string left_range_because;            // empty: it did not

  std::vector<double> elevation(double x) const;  // [m], |x| <= length/2
};

// At rising times from 0 s on. Ends where |b1| exceeds 0.08 length, b2 half of the greatest b1 or
// b3 half of the greatest b1, where the wave at a wall reaches the roof or the bottom, and at once
// in a tank filled to less than 0.2 of its length or within 0.02 of 0.3368 of it. Throws
// std::invalid_argument for an impossible tank, motion, initial mode or time.
ModalRecord run_modal_third_order(const ModalSloshing& sloshing, const std::vector<double>& times);

}  // namespace slosh::reference

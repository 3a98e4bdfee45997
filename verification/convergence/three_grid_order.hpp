// The observed order of three systematically refined steps h1 < h2 < h3 with values f1, f2, f3, and
// the extrapolated value. With r21 = h2 / h1, r32 = h3 / h2, e21 = f2 - f1, e32 = f3 - f2 and s the
// sign of e32 / e21, the order p solves
//   |e32 / e21| = r21^p (r32^p - s) / (r21^p - s)
// This is p = |ln |e32 / e21| + q(p)| / ln r21, q(p) = ln((r21^p - s) / (r32^p - s)) of Celik,
// Ghia, Roache & Freitas 2008 (J. Fluids Eng. 130, 078001, eqs 3a to 3c), but with p's sign: their
// magnitude would report growing differences as falling ones. The right side grows with p, so that
// there is one solution, which is found by bracketing instead of their fixed-point iteration. Then
//   f_ext = (r21^p f1 - f2) / (r21^p - 1) (eq. 5),   GCI = 1.25 |f1 - f_ext| (eq. 7, not divided by
// f1). Valid where p is close to the method's own order. For s < 0 (oscillating values) p has no
// theoretical basis.
#pragma once

#include <optional>

namespace slosh {

// A value that depends on a step: particle spacing, cell size or time step.
struct ValueAtStep {
  double step;   // any unit, above zero
  double value;  // any unit
  // Half width of the value's own 95 % interval, from its time series; same unit as value.
  double noise = 0;
};

// Factor between the estimated error and its 95 % uncertainty where the order is reliable.
constexpr double reliable_safety_factor = 1.25;

// Neighbouring steps of a refinement differ by this factor at least. Whatever else differs between
// two values is multiplied by 1 / (r - 1) in the extrapolation of an error of first order: by more
// than ten below this ratio. (Celik et al. 2008 ask for 1.3 by experience.)
constexpr double least_refinement_ratio = 1.1;

// The order p, limited to -10 to 10; nullopt where two neighbouring values are equal. Requires
// increasing steps and finite values.
std::optional<double> three_grid_order(const ValueAtStep& fine, const ValueAtStep& medium,
                                       const ValueAtStep& coarse);

// f_ext for an order above zero.
double extrapolated_value(const ValueAtStep& fine, const ValueAtStep& medium, double order);

}  // namespace slosh

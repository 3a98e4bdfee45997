// What a method's error costs, over its runs at several resolutions (work-precision diagrams:
// Hairer, Norsett & Wanner, Solving Ordinary Differential Equations I, section II.10). With
// W = ln cost and L = ln error of each run, u their half widths over their values:
//   Pareto front: the runs that no other equals or beats in both cost and error
//   slope s of L = a + s W by least squares, its interval with Student's t of n - 2 degrees of
//     freedom
//   cost at an error e between two neighbours of the front, the first the cheaper:
//     ln C = W_1 + t (W_2 - W_1),   t = (L_1 - ln e) / (L_1 - L_2)
//   and to the first order, all bars independent, with g = (W_2 - W_1) / (L_1 - L_2)
//     u_C^2 = (1 - t)^2 (u_W1^2 + g^2 u_L1^2) + t^2 (u_W2^2 + g^2 u_L2^2)
//   beyond the front's most accurate run n, along the fitted slope s < 0:
//     ln C = W_n + (L_n - ln e) / -s,
//     u_C^2 = u_Wn^2 + (u_Ln / s)^2 + ((L_n - ln e) u_s / s^2)^2,   u_s the slope's half width
// Costs in any unit: core-seconds, bytes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "verification/fits/harmonic_fit.hpp"

namespace slosh {

struct WorkPoint {
  std::string run;
  double resolution;  // in any unit, by which runs of one method are told apart
  Estimate cost;      // a half width of NaN: not known
  Estimate error;
};

// Cheapest first, so that the errors fall strictly. Runs whose cost or error is not finite and
// above zero are left out.
std::vector<WorkPoint> pareto_front(std::vector<WorkPoint> points);

// Of d ln error / d ln cost over all the runs, those on no front included; none of fewer than two
// resolutions, and of two a half width of NaN.
std::optional<Estimate> work_slope(const std::vector<WorkPoint>& points);

enum class Reach {
  not_at_all,
  by_cheapest,   // the cheapest run errs less: the error costs at most that
  between,       // interpolated between two runs
  extrapolated,  // along the fitted slope, which is known to fall
};

struct CostAtError {
  Reach reach = Reach::not_at_all;
  double cost;                          // NaN where not reached
  double cost_spread, error_spread;     // u_C of the costs' bars alone, and of the errors'
  std::vector<std::string> rests_on;    // the one or two runs
  std::optional<WorkPoint> most_exact;  // of all the runs; none where none has a cost and an error
};

// u_C of both kinds of bars; a kind that is not known (NaN) counts nothing.
double known_spread(const CostAtError& found);

// Whether an error is reached is told by the runs' errors as they are: their bars only widen what
// it costs.
CostAtError cost_at_error(const std::vector<WorkPoint>& points, double error);

// The same, where it is not reached but at least half the smallest error that is: extrapolated,
// given three resolutions whose slope's interval lies below zero.
CostAtError cost_at_error_or_beyond(const std::vector<WorkPoint>& points, double error);

}  // namespace slosh

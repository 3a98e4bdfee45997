// The cost of a method as a function of its error, over its runs at several resolutions
// (work-precision diagrams: Hairer, Norsett & Wanner, Solving Ordinary Differential Equations I,
// section II.10). With W = ln cost and L = ln error of each run, u their half widths over their
// values:
//   Pareto front: the runs that no other equals or beats in both cost and error
//   slope s of L = a + s W by least squares, its interval with Student's t of n - 2 degrees of
//     freedom
//   cost at an error e between two neighbours of the front, the first the cheaper:
//     ln C = W_1 + t (W_2 - W_1),   t = (L_1 - ln e) / (L_1 - L_2)
//   and to first order, all bars independent, with g = (W_2 - W_1) / (L_1 - L_2)
//     u_C^2 = (1 - t)^2 (u_W1^2 + g^2 u_L1^2) + t^2 (u_W2^2 + g^2 u_L2^2)
//   beyond the front's most accurate run n, along the fitted slope s < 0:
//     ln C = W_n + (L_n - ln e) / -s,
//     u_C^2 = u_Wn^2 + (u_Ln / s)^2 + ((L_n - ln e) u_s / s^2)^2,   u_s the slope's half width
// Costs are in any unit: core-seconds, bytes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "verification/series/time_series.hpp"

namespace slosh {

struct WorkPoint {
  std::string run;
  double resolution;  // in any unit; distinguishes the runs of one method
  Estimate cost;      // the half width is NaN where it is unknown
  Estimate error;
};

// The Pareto front, cheapest run first, so that the errors strictly decrease. Runs whose cost or
// error is not finite and above zero are left out.
std::vector<WorkPoint> pareto_front(std::vector<WorkPoint> points);

// The slope d ln error / d ln cost over all runs, including those off the front. Returns nullopt
// for fewer than two resolutions; for two the half width is NaN.
std::optional<Estimate> work_slope(const std::vector<WorkPoint>& points);

enum class Reach {
  not_at_all,
  by_cheapest,   // the cheapest run has a smaller error: the error costs at most that run's cost
  between,       // interpolated between two runs
  extrapolated,  // along the fitted slope, where that is significantly negative
};

struct CostAtError {
  Reach reach = Reach::not_at_all;
  double cost;                          // NaN where not reached
  double cost_spread, error_spread;     // u_C from the costs' bars alone, and from the errors'
  std::vector<std::string> rests_on;    // the one or two runs
  std::optional<WorkPoint> most_exact;  // of all runs; nullopt where none has a cost and an error
};

// u_C from both kinds of bars; an unknown kind (NaN) counts as zero.
double known_spread(const CostAtError& found);

// The cost at an error. Whether the error is reached depends on the runs' errors without their
// bars; the bars only widen the cost.
CostAtError cost_at_error(const std::vector<WorkPoint>& points, double error);

// The same, with extrapolation to an error that is not reached, if it is at least half the smallest
// error and there are three resolutions whose slope's interval lies below zero.
CostAtError cost_at_error_or_beyond(const std::vector<WorkPoint>& points, double error);

}  // namespace slosh

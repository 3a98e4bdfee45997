// The straight line through (ln h, ln e) by least squares with equal weights: e = C h^p. With n
// points, the residuals' deviation s = sqrt(sum r^2 / (n - 2)), m the mean of ln h, S the sum of
// (ln h - m)^2 and t the 97.5 % point of Student's distribution of n - 2 degrees of freedom:
//   p +- t s / sqrt(S),   ln e(h) +- t s sqrt(1 / n + (ln h - m)^2 / S)
// (the confidence band of the line: Draper & Smith 1998, sections 1.4 and 3.1). Valid where the
// residuals are scatter and not a curvature of the law.
#pragma once

#include <vector>

#include "verification/convergence/three_grid_order.hpp"
#include "verification/series/time_series.hpp"

namespace slosh {

struct PowerLawLine {
  Estimate order;  // p
  // m, ln e at m, t s, n and S of the formulas above.
  double middle, level, scatter, count, spread;

  struct OnLine {
    double value, lower, upper;
  };
  OnLine at(double step) const;
};

// Throws ComparisonError for fewer than three points, for a step or error that is not finite and
// above zero, and when all steps are equal.
PowerLawLine fit_power_law_line(const std::vector<ValueAtStep>& errors);

}  // namespace slosh

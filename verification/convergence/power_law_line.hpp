// The straight line through (ln h, ln e) by least squares, equal weights: e = C h^p. With n points,
// the residuals' deviation s = sqrt(sum r^2 / (n - 2)), m the mean of ln h and S the sum of
// (ln h - m)^2, t the 97.5 % point of Student's distribution of n - 2 degrees of freedom:
//   p +- t s / sqrt(S),   ln e(h) +- t s sqrt(1 / n + (ln h - m)^2 / S)
// (the band of the line's own mean, as in any text on regression: Draper & Smith 1998, sections 1.4
// and 3.1). Valid where the scatter is that of the points, not of a law that bends.
#pragma once

#include <vector>

#include "verification/convergence/three_grid_order.hpp"
#include "verification/fits/harmonic_fit.hpp"

namespace slosh {

struct PowerLawLine {
  Estimate order;  // p
  // ln e at m, and what the band is made of.
  double middle, level, scatter, count, spread;

  struct OnLine {
    double value, lower, upper;
  };
  OnLine at(double step) const;
};

// Throws ComparisonError of fewer than three points, of one that is not above zero and finite, and
// where all steps are equal.
PowerLawLine fit_power_law_line(const std::vector<ValueAtStep>& errors);

}  // namespace slosh

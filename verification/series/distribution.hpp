// The distribution of a quantity over repeats of one experiment or run whose single outcome is not
// repeatable (an impact's peak pressure). With x_(1) <= ... <= x_(n) the sorted values:
//   mean m = sum x_i / n,   standard deviation = sqrt(sum (x_i - m)^2 / (n - 1))
//   quantile of p: x at the place 1 + (n - 1) p between the sorted values, linear in between
//     (Hyndman & Fan 1996, Am. Stat. 50, 361-365, type 7: the default of R and NumPy)
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "verification/series/time_series.hpp"

namespace slosh {

// The central part of a distribution, in the quantity's unit.
struct Interval {
  double low, high;
};

class Distribution {
 public:
  // Takes values in any order; messages quote the name. Throws ComparisonError when there is no
  // value or one is not finite.
  Distribution(std::string name, std::vector<double> values);

  const std::vector<double>& sorted() const { return sorted_; }
  double mean() const;
  double standard_deviation() const;          // throws ComparisonError for a single value
  double quantile(double probability) const;  // throws ComparisonError outside 0 to 1
  // The percentile rank of x: the percentage of values below it, plus half the percentage of values
  // equal to it. Throws ComparisonError when x is NaN.
  double percentile(double x) const;
  // The quantiles of 5 % and 95 %. Throws ComparisonError for fewer than 20 values: less than one
  // of them would lie outside at either end, and the interval would be that of the extremes.
  Interval central_90_percent() const;

 private:
  std::string name_;
  std::vector<double> sorted_;
};

}  // namespace slosh

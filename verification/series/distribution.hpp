// A quantity over repeats of one experiment or run, none of which can be told beforehand (an
// impact's peak pressure): the distribution of the sample and how far two of them are apart. With
// x_(1) <= ... <= x_(n) the sorted values:
//   mean m = sum x_i / n,   standard deviation = sqrt(sum (x_i - m)^2 / (n - 1))
//   quantile of p: x at the place 1 + (n - 1) p between the sorted values, linear in between
//     (Hyndman & Fan 1996, Am. Stat. 50, 361-365, type 7: what R and NumPy take by default)
//   cdf F(x) = the number of values <= x, divided by n
//   area metric d = integral |F_1(x) - F_2(x)| dx (Ferson, Oberkampf & Ginzburg 2008, Comput.
//     Methods Appl. Mech. Eng. 197, 2408-2430), in the quantity's unit. Of single values it is
//     their distance, of samples shifted against each other the shift, and it is never zero unless
//     the two cdfs are equal.
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
  // Values in any order; the name is for messages. Throws ComparisonError when there is no value or
  // one is not finite.
  Distribution(std::string name, std::vector<double> values);

  const std::vector<double>& sorted() const { return sorted_; }
  double mean() const;
  double standard_deviation() const;          // throws ComparisonError of a single value
  double quantile(double probability) const;  // throws ComparisonError outside 0 to 1
  double cumulative(double x) const;          // F(x), 0 to 1
  // Where a value falls among the sample: the percentage of values below it, those equal to it
  // counted by half. Throws ComparisonError when x is NaN.
  double percentile(double x) const;
  // Quantiles of 5 % and 95 %. Throws ComparisonError of fewer than 20 values: less than one of
  // them lies outside at either end, and the interval would be that of the extremes.
  Interval central_90_percent() const;

 private:
  std::string name_;
  std::vector<double> sorted_;
};

// In the quantity's unit, which must be the same for both.
double area_metric(const Distribution& a, const Distribution& b);

}  // namespace slosh

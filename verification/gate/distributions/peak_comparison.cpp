#include "verification/gate/distributions/peak_comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "verification/gate/distributions/bootstrap_interval.hpp"
#include "verification/gate/distributions/permutation_test.hpp"

namespace slosh {
namespace {

constexpr double of_the_highest = 0.9;
constexpr SeededTrials area_divisions{1999, 2008};

TwoSampleFigure ratio_of_quantiles(double probability) {
  return [probability](const Distribution& one, const Distribution& other) {
    return one.quantile(probability) / other.quantile(probability) - 1;
  };
}

double area_over_mean(const Distribution& one, const Distribution& other) {
  return area_metric(one, other) / other.mean();
}

double area_statistic(const PooledSamples& pooled, const std::vector<int>& counts) {
  return pooled.area(counts);
}

SampleFigure bootstrapped(const Distribution& candidate, const Distribution& experiment,
                          const TwoSampleFigure& figure) {
  const Interval interval = bootstrap_interval(candidate, experiment, figure);
  return {wider_side(figure(candidate, experiment), interval), interval};
}

// The area of two samples is above zero even where that of their distributions is zero, and so is
// every area of samples drawn anew. The interval therefore reaches to zero where random divisions
// of the values have so large an area in 5 % of all cases or more.
SampleFigure area_of(const Distribution& candidate, const Distribution& experiment) {
  SampleFigure area = bootstrapped(candidate, experiment, area_over_mean);
  const double by_chance =
      permutation_quantile(candidate, experiment, area_statistic, 0.95, area_divisions);
  if (area_metric(candidate, experiment) <= by_chance) area.interval.low = 0;
  return {wider_side(area.value.value, area.interval), area.interval};
}

void require_enough(const Distribution& candidate, const Distribution& experiment) {
  for (const auto& [sample, of] :
       {std::pair{&candidate, "the candidate"}, {&experiment, "the experiment"}})
    if (sample->sorted().size() < fewest_repeats)
      throw ComparisonError(
          fmt::format("{} peaks of {}; expected {} or more, as a test on fewer "
                      "accepts nearly anything",
                      sample->sorted().size(), of, fewest_repeats));
  if (!(std::min({experiment.mean(), experiment.quantile(0.5),
                  experiment.quantile(of_the_highest)}) > 0))
    throw ComparisonError("the experiment's peaks have no positive mean and quantiles");
}

}  // namespace

Estimate peak_metric(Metric metric, const Distribution& candidate, const Distribution& experiment) {
  require_enough(candidate, experiment);
  switch (metric) {
    case Metric::peak_mean_p_value:
      return {welch_p_value(candidate, experiment), 0};
    case Metric::peak_ks_p_value:
      return permutation_p_value(candidate, experiment, kolmogorov_smirnov_statistic);
    case Metric::peak_ad_p_value:
      return permutation_p_value(candidate, experiment, anderson_darling_statistic);
    case Metric::peak_area:
      return area_of(candidate, experiment).value;
    case Metric::peak_median_error:
      return bootstrapped(candidate, experiment, ratio_of_quantiles(0.5)).value;
    case Metric::peak_p90_error:
      return bootstrapped(candidate, experiment, ratio_of_quantiles(of_the_highest)).value;
    default:
      throw std::logic_error("two samples of peaks have no " + metric_name(metric));
  }
}

PeakComparison compare_peaks(const Distribution& candidate, const Distribution& experiment) {
  require_enough(candidate, experiment);
  return {.mean_p = peak_metric(Metric::peak_mean_p_value, candidate, experiment),
          .ks_p = peak_metric(Metric::peak_ks_p_value, candidate, experiment),
          .ad_p = peak_metric(Metric::peak_ad_p_value, candidate, experiment),
          .area = area_of(candidate, experiment),
          .median_error = bootstrapped(candidate, experiment, ratio_of_quantiles(0.5)),
          .p90_error = bootstrapped(candidate, experiment, ratio_of_quantiles(of_the_highest))};
}

}  // namespace slosh

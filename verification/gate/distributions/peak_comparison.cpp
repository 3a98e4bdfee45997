#include "verification/gate/distributions/peak_comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "verification/gate/distributions/bootstrap_interval.hpp"
#include "verification/gate/distributions/permutation_test.hpp"

namespace slosh {
namespace {

double ratio_of_medians(const Distribution& one, const Distribution& other) {
  return one.quantile(0.5) / other.quantile(0.5) - 1;
}

SampleFigure median_error(const Distribution& candidate, const Distribution& experiment) {
  const Interval interval = bootstrap_interval(candidate, experiment, ratio_of_medians);
  return {wider_side(ratio_of_medians(candidate, experiment), interval), interval};
}

void require_enough(const Distribution& candidate, const Distribution& experiment) {
  for (const auto& [sample, of] :
       {std::pair{&candidate, "the candidate"}, {&experiment, "the experiment"}})
    if (sample->sorted().size() < fewest_repeats)
      throw ComparisonError(
          fmt::format("{} peaks of {}; expected {} or more, as a test on fewer "
                      "accepts nearly anything",
                      sample->sorted().size(), of, fewest_repeats));
  if (!(std::min(experiment.mean(), experiment.quantile(0.5)) > 0))
    throw ComparisonError("the experiment's peaks have no positive mean and median");
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
    case Metric::peak_median_error:
      return median_error(candidate, experiment).value;
    default:
      throw std::logic_error("two samples of peaks have no " + metric_name(metric));
  }
}

PeakComparison compare_peaks(const Distribution& candidate, const Distribution& experiment) {
  require_enough(candidate, experiment);
  return {.mean_p = peak_metric(Metric::peak_mean_p_value, candidate, experiment),
          .ks_p = peak_metric(Metric::peak_ks_p_value, candidate, experiment),
          .ad_p = peak_metric(Metric::peak_ad_p_value, candidate, experiment),
          .median_error = median_error(candidate, experiment)};
}

}  // namespace slosh

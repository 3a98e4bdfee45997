#include "verification/gate/distributions/repeated_impacts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "verification/gate/distributions/bootstrap_interval.hpp"
#include "verification/gate/distributions/median_interval.hpp"
#include "verification/gate/distributions/peak_comparison.hpp"
#include "verification/gate/impact_metrics.hpp"

namespace slosh {
namespace {

// The members' median. One that has no impact leaves none to the ensemble.
Estimate median_of_repeats(const GateRow& row, const std::vector<const TimeSeries*>& pressures,
                           const TimeSeries* record, const CaseDefinition& definition) {
  std::vector<double> values;
  for (const TimeSeries* pressure : pressures) {
    values.push_back(impact_metric(row.metric, row.mode, *pressure, record, definition));
    if (!std::isfinite(values.back())) return {not_a_number, 0};
  }
  const Distribution sample(metric_name(row.metric) + " of " + row.candidate, std::move(values));
  Estimate median = wider_side(sample.quantile(0.5), median_interval(sample));
  if (row.metric == Metric::impact_arrival)
    median.half_width = std::min(median.half_width, definition.impacts.value().period / 4);
  return median;
}

}  // namespace

Estimate repeated_impact_metric(const GateRow& row, const std::vector<const TimeSeries*>& pressures,
                                const TimeSeries* record, const CaseDefinition& definition) {
  if (!is_of_repeats(row.metric)) return median_of_repeats(row, pressures, record, definition);
  const std::size_t n = impact_number(row.mode, definition);
  const Distribution experiment = repeated_peaks(definition, n);
  if (pressures.size() < fewest_repeats)
    throw ComparisonError(
        fmt::format("{} of {}: {} {}; expected an ensemble of {} repeats or more, as a test on "
                    "fewer accepts nearly anything (repeats = {} of its [[run]])",
                    metric_name(row.metric), row.candidate, pressures.size(),
                    pressures.size() == 1 ? "run" : "repeats", fewest_repeats, fewest_repeats));
  std::vector<double> peaks;
  bool occurs_in_all = true;
  for (const TimeSeries* pressure : pressures) {
    const std::optional<ImpactPeak> peak = peak_in(*pressure, n, record, definition);
    occurs_in_all &= peak.has_value();
    if (peak) peaks.push_back(peak->pressure);
  }
  if (!occurs_in_all) return {not_a_number, 0};
  return peak_metric(row.metric, Distribution("peaks of " + row.candidate, std::move(peaks)),
                     experiment);
}

}  // namespace slosh

#include "verification/gate/distributions/repeated_impacts.hpp"

#include <fmt/format.h>

#include <optional>

#include "verification/gate/distributions/peak_comparison.hpp"
#include "verification/gate/impact_metrics.hpp"

namespace slosh {

Estimate repeated_impact_metric(const GateRow& row, const std::vector<const TimeSeries*>& pressures,
                                const TimeSeries* record, const CaseDefinition& definition) {
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

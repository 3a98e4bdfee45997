#include "verification/runs/filtered_pressures.hpp"

#include <algorithm>
#include <optional>

#include "verification/case/quantities.hpp"
#include "verification/series/low_pass_filter.hpp"

namespace slosh {
namespace {

std::optional<TimeSeries> find_series(const RunResult& result, const std::string& name) {
  for (const TimeSeries& one : result.series)
    if (one.name == name) return one;
  return std::nullopt;
}

void replace_series(RunResult& result, TimeSeries series) {
  std::erase_if(result.series, [&](const TimeSeries& one) { return one.name == series.name; });
  result.series.push_back(std::move(series));
}

}  // namespace

std::vector<std::string> add_filtered_pressures(const CaseDefinition& definition,
                                                RunResult& result) {
  std::vector<std::string> failures;
  for (const PressureGaugeDefinition& gauge : definition.pressure_gauges) {
    if (!gauge.filter_cutoff) continue;
    const std::string quantity = wall_pressure(gauge.name);
    for (const std::string suffix : {"", lower_edge, upper_edge, coarser, finer, nonlinear}) {
      const std::optional<TimeSeries> series = find_series(result, quantity + suffix);
      if (!series) continue;
      try {
        TimeSeries filtered = low_pass(*series, *gauge.filter_cutoff);
        filtered.name = quantity + through_filter + suffix;
        replace_series(result, std::move(filtered));
      } catch (const ComparisonError& error) {
        failures.push_back(error.what());
      }
    }
  }
  return failures;
}

}  // namespace slosh

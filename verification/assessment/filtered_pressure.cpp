#include "verification/assessment/filtered_pressure.hpp"

#include "verification/series/low_pass_filter.hpp"

namespace slosh {

std::vector<std::string> add_filtered_pressures(const CaseDefinition& definition, CaseRuns& runs) {
  std::vector<std::string> failures;
  for (const PressureGaugeDefinition& gauge : definition.pressure_gauges) {
    if (!gauge.filter_cutoff) continue;
    const std::string quantity = "wall_pressure@" + gauge.name;
    for (auto& [name, result] : runs.results) {
      if (!has_series(runs, name, quantity)) continue;
      try {
        result.series.push_back(low_pass(result.at(quantity), *gauge.filter_cutoff));
      } catch (const ComparisonError& error) {
        failures.push_back(name + ": " + error.what());
      }
    }
  }
  return failures;
}

}  // namespace slosh

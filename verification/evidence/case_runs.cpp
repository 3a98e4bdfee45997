#include "verification/evidence/case_runs.hpp"

#include <algorithm>

#include "verification/case/quantities.hpp"
#include "verification/runs/run_case.hpp"
#include "verification/series/low_pass_filter.hpp"

namespace slosh {

bool has_series(const CaseRuns& runs, const std::string& run, const std::string& quantity) {
  const auto result = runs.results.find(run);
  return result != runs.results.end() &&
         std::any_of(result->second.series.begin(), result->second.series.end(),
                     [&](const TimeSeries& one) { return one.name == quantity; });
}

RunResult judged_part(const RunResult& result, const std::string& quantity) {
  RunResult part{};
  part.case_name = result.case_name;
  part.run_name = result.run_name;
  part.diagnostics = result.diagnostics;
  part.cost = result.cost;
  for (const TimeSeries& one : result.series)
    if (one.name == quantity || one.name == quantity + coarser) part.series.push_back(one);
  return part;
}

const TimeSeries* series_of_record(const CaseDefinition& definition, const CaseRuns& runs,
                                   const std::string& quantity) {
  for (const RunDefinition& run : definition.runs) {
    const RecordRun* record = std::get_if<RecordRun>(&run.solver);
    if (record && !record->earlier_run && has_series(runs, run.name, quantity))
      return &runs.results.at(run.name).at(quantity);
  }
  return nullptr;
}

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

#include "verification/evidence/case_runs.hpp"

#include <algorithm>

#include "verification/case/quantities.hpp"
#include "verification/runs/filtered_pressures.hpp"

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
    for (const char* suffix : {"", coarser, finer, nonlinear, lower_edge, upper_edge})
      if (one.name == quantity + suffix) part.series.push_back(one);
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

std::vector<std::string> complete_results(const CaseDefinition& definition, CaseRuns& runs) {
  std::vector<std::string> failures;
  for (auto& [name, result] : runs.results) {
    raise_dry_gauges(definition, run_named(definition, name), result);
    for (const std::string& why : add_filtered_pressures(definition, result))
      failures.push_back(name + ": " + why);
  }
  return failures;
}

TimeWindow compared_window(const CaseDefinition& definition, const std::string& reference) {
  TimeWindow window{definition.window_begin, definition.window_end};
  if (const auto* record = std::get_if<RecordRun>(&run_named(definition, reference).solver)) {
    window.begin = std::max(window.begin, record->time.front());
    window.end = std::min(window.end, record->time.back());
  }
  return window;
}

}  // namespace slosh

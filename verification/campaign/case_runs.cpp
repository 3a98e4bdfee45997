#include "verification/campaign/case_runs.hpp"

#include <algorithm>
#include <stdexcept>

#include "verification/runs/run_case.hpp"

namespace slosh {

bool has_series(const CaseRuns& runs, const std::string& run, const std::string& quantity) {
  const auto& series = runs.results.at(run).series;
  return std::any_of(series.begin(), series.end(),
                     [&](const TimeSeries& one) { return one.name == quantity; });
}

const RunDefinition& run_named(const CaseDefinition& definition, const std::string& name) {
  const auto found = std::find_if(definition.runs.begin(), definition.runs.end(),
                                  [&](const RunDefinition& run) { return run.name == name; });
  if (found == definition.runs.end())
    throw std::invalid_argument("case " + definition.name + " has no run " + name);
  return *found;
}

RunResult judged_part(const RunResult& result, const std::string& quantity) {
  RunResult part{};
  part.case_name = result.case_name;
  part.run_name = result.run_name;
  part.diagnostics = result.diagnostics;
  for (const TimeSeries& one : result.series)
    if (one.name == quantity || one.name == quantity + coarser) part.series.push_back(one);
  return part;
}

const TimeSeries* series_of_record(const CaseDefinition& definition, const CaseRuns& runs,
                                   const std::string& quantity) {
  for (const RunDefinition& run : definition.runs)
    if (std::holds_alternative<RecordRun>(run.solver) && runs.results.contains(run.name) &&
        has_series(runs, run.name, quantity))
      return &runs.results.at(run.name).at(quantity);
  return nullptr;
}

}  // namespace slosh

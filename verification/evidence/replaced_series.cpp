#include "verification/evidence/replaced_series.hpp"

#include "verification/evidence/case_evidence.hpp"
#include "verification/gate/measured_value.hpp"

namespace slosh {

Estimate measured_with(const CaseDefinition& definition, const CaseRuns& runs, const GateRow& row,
                       const std::string& run, const TimeSeries& series) {
  CaseRuns replaced;
  for (const auto& [name, result] : runs.results) {
    const bool is_needed = name == row.candidate || name == row.reference ||
                           std::holds_alternative<RecordRun>(run_named(definition, name).solver);
    if (!is_needed) continue;
    replaced.results[name] = judged_part(result, row.quantity);
    replaced.status[name] = runs.status.at(name);
  }
  for (TimeSeries& one : replaced.results.at(run).series)
    if (one.name == row.quantity) one = series;
  CaseEvidence evidence(definition, replaced, nullptr, asked_by({row}));
  return measured(row, evidence.gate_evidence());
}

}  // namespace slosh

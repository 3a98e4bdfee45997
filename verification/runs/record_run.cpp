#include "verification/runs/solver_runs.hpp"

namespace slosh {

// The case parser has read and checked the record.
void require_scene(const RecordRun&, const CaseDefinition&, const RunDefinition&) {}

RunResult run_record(const RecordRun& record, const RunRequest& request) {
  RunResult result;
  result.series.push_back({record.quantity, record.unit, record.time, record.value});
  result.active_terms = {"published record"};
  if (record.uncertainty) result.diagnostics["uncertainty_" + record.unit] = *record.uncertainty;
  request.progress(record.time.back(), 0);
  return result;
}

}  // namespace slosh

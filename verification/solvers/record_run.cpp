#include <fmt/format.h>

#include "verification/case/quantities.hpp"
#include "verification/solvers/solver_runs.hpp"

namespace slosh {

std::string where_to_get(const RecordRun& record, const CaseDefinition& definition) {
  return fmt::format(
      "expected {}, below the directory of --experiments or SLOSH_EXPERIMENTS; "
      "where to get the original: {}",
      record.file.string(), definition.source);
}

// The case parser has already read and checked the record, or found that it is not supplied.
void require_scene(const RecordRun&, const CaseDefinition&, const RunDefinition&) {}

RunResult run_solver(const RecordRun& record, const RunRequest& request) {
  if (!record.supplied) throw refused(request.run, where_to_get(record, request.definition));
  RunResult result;
  result.series.push_back({record.quantity, record.unit, record.time, record.value});
  if (record.has_band) {
    result.series.push_back({record.quantity + lower_edge, record.unit, record.time, record.lower});
    result.series.push_back({record.quantity + upper_edge, record.unit, record.time, record.upper});
  }
  result.active_terms = {"published record"};
  if (record.uncertainty) result.diagnostics["uncertainty_" + record.unit] = *record.uncertainty;
  request.progress(record.time.back(), 0);
  return result;
}

}  // namespace slosh

#include "verification/campaign/row_uncertainty.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "verification/campaign/case_evidence.hpp"
#include "verification/campaign/repeat_spread.hpp"
#include "verification/case_file/metric_table.hpp"
#include "verification/runs/run_case.hpp"

namespace slosh {
namespace {

double reference_amplitude(const Comparison& comparison, const std::string& mode) {
  const auto found = std::find_if(comparison.modes.begin(), comparison.modes.end(),
                                  [&](const ModeComparison& one) { return one.mode == mode; });
  return found == comparison.modes.end() ? 0 : found->reference.amplitude.value;
}

// The metric against the same potential flow of fewer nodes.
double measure_against_coarser(const CaseDefinition& definition, const CaseRuns& runs,
                               const GateRow& row) {
  CaseRuns with_coarser;
  for (const std::string& run : {row.candidate, row.reference}) {
    with_coarser.results[run] = judged_part(runs.results.at(run), row.quantity);
    with_coarser.status[run] = runs.status.at(run);
  }
  std::vector<TimeSeries>& series = with_coarser.results.at(row.reference).series;
  std::erase_if(series, [&](const TimeSeries& one) { return one.name == row.quantity; });
  for (TimeSeries& one : series)
    if (one.name == row.quantity + coarser) one.name = row.quantity;
  CaseEvidence evidence(definition, with_coarser);
  return measured(row, evidence.gate_evidence()).value;
}

}  // namespace

double uncertainty_from_values(Metric metric, const std::string& mode, const Comparison& comparison,
                               double half_width) {
  switch (metric) {
    case Metric::amplitude_error:
      return half_width / reference_amplitude(comparison, mode);
    case Metric::phase_lag:
      return 180 / std::numbers::pi * half_width / reference_amplitude(comparison, mode);
    default:
      return 0;
  }
}

UncertaintyContributions row_uncertainty(const CaseDefinition& definition, const CaseRuns& runs,
                                         const GateRow& row, const FindComparison& comparison,
                                         const MeasureRow& measure) {
  UncertaintyContributions found;
  if (row.metric == Metric::cost_to_reach) return found;
  found.statistics = repeat_spread(definition, runs, row, measure);
  const auto numerical = [&](Role role) {
    return numerical_uncertainty(refined_metrics(definition, runs, row, role, measure));
  };
  if (is_of_impacts(row.metric)) {  // against what is published of an experiment
    found.discretisation = numerical(Role::candidate);
    return found;
  }
  if (row.reference.empty()) return found;
  const RunDefinition& reference = run_named(definition, row.reference);
  if (const auto* record = std::get_if<RecordRun>(&reference.solver)) {
    found.discretisation = numerical(Role::candidate);
    if (record->uncertainty)
      found.reference = uncertainty_from_values(
          row.metric, row.mode, comparison(row.candidate, row.reference, row.quantity),
          *record->uncertainty);
  } else if (std::holds_alternative<PotentialRun>(reference.solver)) {
    found.reference = std::abs(measure_against_coarser(definition, runs, row) - measure(row).value);
  } else {
    found.reference = numerical(Role::reference);
  }
  return found;
}

}  // namespace slosh

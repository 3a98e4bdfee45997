#include "verification/campaign/row_uncertainty.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "verification/campaign/case_evidence.hpp"
#include "verification/campaign/repeat_spread.hpp"
#include "verification/gate/impact_metrics.hpp"
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

// The role's run on its refinement paths.
Contribution numerical(const CaseDefinition& definition, const CaseRuns& runs, const GateRow& row,
                       Role role, const MeasureRow& measure) {
  const std::vector<RefinedMetric> paths = refined_metrics(definition, runs, row, role, measure);
  if (!paths.empty()) {
    std::vector<std::string> names;
    for (const RefinedMetric& path : paths) names.push_back(path.path);
    return {numerical_uncertainty(paths),
            fmt::format("refinement of the {}", fmt::join(names, ", "))};
  }
  return Contribution::unknown(
      fmt::format("the numerical uncertainty of the {} {} is unknown; a [[refinement]] of it with "
                  "another step would tell it",
                  role == Role::candidate ? "candidate" : "reference",
                  role == Role::candidate ? row.candidate : row.reference));
}

Contribution of_record(const RecordRun& record, const GateRow& row,
                       const FindComparison& comparison) {
  if (!record.uncertainty)
    return Contribution::unknown(
        fmt::format("the record {} declares no uncertainty; the key `uncertainty` would tell it",
                    row.reference));
  return {uncertainty_from_values(row.metric, row.mode,
                                  comparison(row.candidate, row.reference, row.quantity),
                                  *record.uncertainty),
          "the record's declared uncertainty"};
}

Contribution of_reference(const CaseDefinition& definition, const CaseRuns& runs,
                          const GateRow& row, const FindComparison& comparison,
                          const MeasureRow& measure) {
  if (row.reference.empty())
    return {0, "no reference: what is measured is zero where all is right"};
  const auto& solver = run_named(definition, row.reference).solver;
  if (const auto* record = std::get_if<RecordRun>(&solver))
    return of_record(*record, row, comparison);
  if (std::holds_alternative<PotentialRun>(solver))
    return {std::abs(measure_against_coarser(definition, runs, row) - measure(row).value),
            "the same potential flow of fewer nodes"};
  if (std::holds_alternative<LinearRun>(solver) || std::holds_alternative<ViscousWaveRun>(solver))
    return {0, "exact solution, inside its range"};
  return numerical(definition, runs, row, Role::reference, measure);
}

}  // namespace

bool rests_on_experiment(const CaseDefinition& definition, const GateRow& row) {
  if (row.reference.empty()) return is_of_impacts(row.metric);
  return std::holds_alternative<RecordRun>(run_named(definition, row.reference).solver);
}

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
  found.reference = of_reference(definition, runs, row, comparison, measure);
  found.discretisation =
      rests_on_experiment(definition, row)
          ? numerical(definition, runs, row, Role::candidate, measure)
          : Contribution{0, "the candidate's discretisation error is what the row measures"};
  found.input = {0, "both sides are told the same"};
  return found;
}

}  // namespace slosh

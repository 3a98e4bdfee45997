#include "verification/evidence/row_uncertainty.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "verification/case/metric_table.hpp"
#include "verification/evidence/record_uncertainty.hpp"
#include "verification/evidence/repeat_spread.hpp"
#include "verification/runs/run_case.hpp"

namespace slosh {
namespace {

// The limit of a regression row was measured with the same runs against the same reference.
Contribution as_when_measured(const char* how) {
  return {0, fmt::format("as large as when the limit was measured, {}", how)};
}

// The role's run on its refinement paths.
Contribution numerical(const CaseDefinition& definition, const CaseRuns& runs, const GateRow& row,
                       Role role, const MeasureRow& measure) {
  const std::vector<RefinedMetric> paths = refined_metrics(definition, runs, row, role, measure);
  if (!paths.empty()) {
    std::vector<std::string> names;
    for (const RefinedMetric& path : paths) names.push_back(path.path);
    if (row.kind == RowKind::regression) return as_when_measured("with the same step");
    return {numerical_uncertainty(paths),
            fmt::format("refinement of the {}", fmt::join(names, ", "))};
  }
  return Contribution::unknown(
      fmt::format("the numerical uncertainty of the {} {} is unknown; a [[refinement]] of it with "
                  "another step would tell it",
                  role == Role::candidate ? "candidate" : "reference",
                  role == Role::candidate ? row.candidate : row.reference));
}

Contribution of_record(const CaseDefinition& definition, const CaseRuns& runs, const GateRow& row,
                       const RecordRun& record, const FindComparison& comparison) {
  if (row.kind == RowKind::regression) return as_when_measured("against the same record");
  if (!record.uncertainty)
    return Contribution::unknown(fmt::format(
        "the record {} declares no uncertainty; the key `uncertainty` of its run would tell it",
        row.reference));
  return {record_uncertainty(definition, runs, row,
                             comparison(row.candidate, row.reference, row.quantity),
                             *record.uncertainty),
          "the record's declared uncertainty"};
}

// Of what is published of impacts beside the pressure itself.
Contribution of_impacts(const ImpactsDefinition& impacts, const GateRow& row, double value) {
  const auto half_width = [&](const std::optional<double>& declared, double scale,
                              const char* key) {
    return declared ? Contribution(*declared * scale, "declared in [impacts]")
                    : Contribution::unknown(fmt::format(
                          "[impacts] declares no uncertainty; its key {} would tell it", key));
  };
  if (row.metric == Metric::impact_time)
    return half_width(impacts.times_half_width, 1, "times_half_width_s");
  if (row.metric == Metric::plateau_error)
    return half_width(impacts.plateau_half_width, std::abs(1 + value) / impacts.plateau,
                      "plateau_half_width_Pa");
  // The share of the repeats below the peak, by the normal approximation of the binomial.
  const double repeats =
      static_cast<double>(impacts.repeats.empty() ? 1 : impacts.repeats[0].size());
  return {1.96 * std::sqrt(std::max(0.0, value * (1 - value)) / repeats),
          "the finite number of repeats"};
}

Contribution of_reference(const CaseDefinition& definition, const CaseRuns& runs,
                          const GateRow& row, const RowMeasures& measures) {
  if (is_of_impacts(row.metric))
    return of_impacts(definition.impacts.value(), row, measures.measure(row).value);
  if (row.reference.empty())
    return {0, "no reference: what is measured is zero where all is right"};
  if (row.metric == Metric::decay_rate)
    return {0, "the decay is the candidate's own: the reference only tells its frequency"};
  const auto& solver = run_named(definition, row.reference).solver;
  if (const auto* record = std::get_if<RecordRun>(&solver))
    return of_record(definition, runs, row, *record, measures.comparison);
  if (std::holds_alternative<PotentialRun>(solver))
    return {std::abs(measures.measure_against_coarser(row).value - measures.measure(row).value),
            "the same potential flow of fewer nodes"};
  if (std::holds_alternative<LinearRun>(solver) || std::holds_alternative<ViscousWaveRun>(solver))
    return {0, "exact solution, inside its range"};
  return numerical(definition, runs, row, Role::reference, measures.measure);
}

Contribution of_inputs(const CaseDefinition& definition, const GateRow& row,
                       const RowMeasures& measures) {
  if (!rests_on_experiment(definition, row))
    return {0, "both sides are told the same tank, liquid and motion"};
  if (row.kind == RowKind::regression) return as_when_measured("with the same inputs");
  return measures.input(row);
}

}  // namespace

bool rests_on_experiment(const CaseDefinition& definition, const GateRow& row) {
  if (row.reference.empty()) return is_of_impacts(row.metric);
  return std::holds_alternative<RecordRun>(run_named(definition, row.reference).solver);
}

UncertaintyContributions row_uncertainty(const CaseDefinition& definition, const CaseRuns& runs,
                                         const GateRow& row, const RowMeasures& measures) {
  UncertaintyContributions found;
  if (row.metric == Metric::cost_to_reach) return found;
  found.statistics = repeat_spread(definition, runs, row, measures.measure);
  found.reference = of_reference(definition, runs, row, measures);
  found.discretisation =
      rests_on_experiment(definition, row)
          ? numerical(definition, runs, row, Role::candidate, measures.measure)
          : Contribution{0, "the candidate's discretisation error is what the row measures"};
  found.input = of_inputs(definition, row, measures);
  return found;
}

}  // namespace slosh

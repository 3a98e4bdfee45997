#include "verification/gate/field_metrics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "verification/case/field_times.hpp"
#include "verification/series/sample_moments.hpp"

namespace slosh {
namespace {

const FieldSnapshot& field_of(const RunResult& result, const CaseDefinition& definition,
                              double time) {
  if (const FieldSnapshot* field = snapshot_at(definition, result, time)) return *field;
  throw ComparisonError(fmt::format("{} has no field at {:g} s", result.run_name, time));
}

// The metric of one moment.
double value_of(Metric metric, const FieldDifference& moment, const CaseDefinition& definition) {
  if (metric == Metric::pressure_field_rms)
    return moment.pressure_rms / pressure_under_depth(definition);
  if (metric == Metric::pressure_field_tension) return moment.tension_share;
  throw std::logic_error("a field has no value of " + metric_name(metric));
}

}  // namespace

double pressure_under_depth(const CaseDefinition& definition) {
  return definition.liquid.density * definition.gravity * definition.liquid.fill_depth;
}

const FieldSnapshot* snapshot_at(const CaseDefinition& definition, const RunResult& result,
                                 double time) {
  const auto& snapshots = result.snapshots;
  const double tolerance = 0.5 * definition.sample_interval;
  const auto found = std::find_if(snapshots.begin(), snapshots.end(), [&](const auto& snapshot) {
    return std::abs(snapshot.time - time) < tolerance;
  });
  return found == snapshots.end() ? nullptr : &*found;
}

FieldDifference field_difference_at(std::size_t n, const RunResult& candidate,
                                    const RunResult& reference, const CaseDefinition& definition) {
  const double time = definition.snapshot_times.at(n);
  return field_difference(field_of(candidate, definition, time),
                          field_of(reference, definition, time),
                          small_tension_share * pressure_under_depth(definition));
}

FieldComparison compare_fields(const RunResult& candidate, const RunResult& reference,
                               const CaseDefinition& definition) {
  if (definition.snapshot_times.empty())
    throw ComparisonError("the case " + definition.name + " has no snapshot times");
  FieldComparison comparison{candidate.run_name, reference.run_name, {}};
  for (std::size_t n = 0; n < definition.snapshot_times.size(); ++n)
    comparison.moments.push_back(field_difference_at(n, candidate, reference, definition));
  return comparison;
}

std::vector<FieldDifference> judged_moments(const std::string& mode, const RunResult& candidate,
                                            const RunResult& reference,
                                            const CaseDefinition& definition) {
  if (mode == "whole") return compare_fields(candidate, reference, definition).moments;
  const std::vector<std::string> names = moment_names(definition);
  const auto found = std::find(names.begin(), names.end(), mode);
  if (found == names.end()) throw ComparisonError("the case has no " + mode);
  return {field_difference_at(static_cast<std::size_t>(found - names.begin()), candidate, reference,
                              definition)};
}

double field_metric(const GateRow& row, const RunResult& candidate, const RunResult& reference,
                    const CaseDefinition& definition) {
  std::vector<double> values;
  for (const FieldDifference& moment : judged_moments(row.mode, candidate, reference, definition))
    values.push_back(value_of(row.metric, moment, definition));
  return mean(values);
}

}  // namespace slosh

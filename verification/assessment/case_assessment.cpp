#include "verification/assessment/case_assessment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <stdexcept>
#include <utility>

#include "verification/assessment/doubts/verdict_doubts.hpp"
#include "verification/assessment/validity_envelope.hpp"
#include "verification/case/ensemble.hpp"
#include "verification/case/metric_table.hpp"
#include "verification/case/quantities.hpp"
#include "verification/case/solver_kinds.hpp"
#include "verification/evidence/case_evidence.hpp"
#include "verification/evidence/input_uncertainty.hpp"
#include "verification/evidence/run_cost.hpp"

namespace slosh {
namespace {

template <class Solver>
const Solver* solver_as(const CaseDefinition& definition, const std::string& run) {
  return std::get_if<Solver>(&run_named(definition, run).solver);
}

bool has_result(const CaseRuns& runs, const std::string& run) { return runs.results.contains(run); }

// A potential flow that has ended early is too short to compare. An earlier run of this harness is
// a reference only for the rows that name it.
bool can_be_compared(const RunDefinition& reference, const CaseRuns& runs) {
  const RecordRun* record = std::get_if<RecordRun>(&reference.solver);
  return has_result(runs, reference.name) && !(record && record->earlier_run) &&
         !(is_theory(reference) && solver_kind(reference).can_end_early &&
           runs.status.at(reference.name).state == RunState::out_of_range);
}

// The finest interFoam run that has a result, with which SPH is compared. Returns "" where there is
// none.
std::string finest_interfoam(const CaseDefinition& definition, const CaseRuns& runs) {
  std::string finest;
  double most_cells = 0;
  for (const auto& [name, result] : runs.results) {
    const InterFoamRun* mesh = solver_as<InterFoamRun>(definition, name);
    if (!mesh || mesh->program != FoamProgram::inter_foam || number_of_cells(*mesh) <= most_cells)
      continue;
    most_cells = number_of_cells(*mesh);
    finest = name;
  }
  return finest;
}

bool has_two_layer_theory(const CaseDefinition& definition) {
  return std::any_of(definition.runs.begin(), definition.runs.end(),
                     [](const RunDefinition& run) { return is_theory(run) && sees_gas(run); });
}

using Pair = std::pair<std::string, std::string>;

// The compared candidates and references, in the order of the case file.
std::vector<Pair> compared_pairs(const CaseDefinition& definition, const CaseRuns& runs) {
  const std::string mesh = finest_interfoam(definition, runs);
  const bool two_layers = has_two_layer_theory(definition);
  std::vector<Pair> pairs;
  for (const RunDefinition& candidate : definition.runs) {
    if (!has_result(runs, candidate.name) || is_theory(candidate) || is_later_member(candidate) ||
        is_record(candidate))
      continue;
    const bool has_gas = sees_gas(candidate);
    for (const RunDefinition& reference : definition.runs) {
      if (!can_be_compared(reference, runs)) continue;
      const LinearRun* linear = std::get_if<LinearRun>(&reference.solver);
      const bool of_its_kind =
          linear ? linear->two_layer == (has_gas && two_layers) : !is_simulation(reference);
      if (of_its_kind) pairs.push_back({candidate.name, reference.name});
    }
    if (!has_gas && !mesh.empty()) pairs.push_back({candidate.name, mesh});
  }
  return pairs;
}

// A comparison with a record is on the record's quantity. An external program is compared on the
// quantities that it declares. Any other pair is compared on the quantities of the case's gauges
// and on all others that both runs left.
std::vector<std::string> quantities_of(const CaseDefinition& definition, const CaseRuns& runs,
                                       const Pair& pair) {
  if (const RecordRun* record = solver_as<RecordRun>(definition, pair.second))
    return {record->quantity};
  std::vector<std::string> quantities = compared_quantities(definition);
  const bool declares_its_own = solver_kind(run_named(definition, pair.first)).declares_quantities;
  std::erase_if(quantities, [&](const std::string& quantity) {
    return (declares_its_own || !is_gauged(quantity)) &&
           !(has_series(runs, pair.first, quantity) && has_series(runs, pair.second, quantity));
  });
  return quantities;
}

// The interFoam runs on whose mesh fields are compared, the finest first.
std::vector<std::string> field_references(const CaseDefinition& definition, const CaseRuns& runs) {
  std::vector<std::string> references;
  const auto add = [&](const std::string& run) {
    if (has_result(runs, run) && !runs.results.at(run).snapshots.empty() &&
        std::find(references.begin(), references.end(), run) == references.end())
      references.push_back(run);
  };
  add(finest_interfoam(definition, runs));
  for (const GateRow& row : definition.gate)
    if (is_of_fields(row.metric)) add(row.reference);
  return references;
}

void compare_all_fields(CaseAssessment& assessment) {
  const CaseDefinition& definition = assessment.definition;
  const CaseRuns& runs = assessment.runs;
  if (definition.snapshot_times.empty()) return;
  for (const std::string& reference : field_references(definition, runs))
    for (const RunDefinition& candidate : definition.runs) {
      const std::string& name = candidate.name;
      if (name == reference || is_later_member(candidate) || !has_result(runs, name) ||
          runs.results.at(name).snapshots.empty())
        continue;
      try {
        FieldComparison compared =
            compare_fields(runs.results.at(name), runs.results.at(reference), definition);
        compared.candidate = name;
        compared.reference = reference;
        assessment.fields.push_back(std::move(compared));
      } catch (const ComparisonError& error) {
        assessment.not_comparable.push_back(
            fmt::format("the fields of {} against {}: {}", name, reference, error.what()));
      }
    }
}

}  // namespace

const FieldComparison* fields_compared(const CaseAssessment& assessment,
                                       const std::string& candidate, const std::string& reference) {
  for (const FieldComparison& one : assessment.fields)
    if (one.candidate == candidate && one.reference == reference) return &one;
  return nullptr;
}

bool has_selected_runs(const CaseAssessment& assessment) {
  const auto& status = assessment.runs.status;
  return std::any_of(status.begin(), status.end(), [](const auto& of_run) {
    return of_run.second.state != RunState::not_selected;
  });
}

std::vector<const Comparison*> judging_comparisons(const CaseAssessment& assessment) {
  const std::string quantity = compared_quantities(assessment.definition).front();
  std::vector<const Comparison*> judging;
  std::set<std::string> counted;
  for (const Comparison& comparison : assessment.comparisons)
    if (comparison.quantity == quantity &&
        assessment.runs.status.at(comparison.reference).state != RunState::out_of_range &&
        counted.insert(comparison.candidate).second)
      judging.push_back(&comparison);
  return judging;
}

const TimeSeries* series_of_record(const CaseAssessment& assessment, const std::string& quantity) {
  return series_of_record(assessment.definition, assessment.runs, quantity);
}

const Comparison* comparison_with_truth(const CaseAssessment& assessment, const std::string& run) {
  for (const Comparison* judging : judging_comparisons(assessment))
    if (judging->candidate == run &&
        !is_simulation(run_named(assessment.definition, judging->reference)))
      return judging;
  return nullptr;
}

CaseAssessment assess(CaseDefinition definition, CaseRuns runs) {
  mark_out_of_range(definition, runs);
  mark_other_costs(definition, runs);
  predict_input_bounds(definition, runs);
  std::vector<std::string> not_filtered = complete_results(definition, runs);
  collect_input_bounds(definition, runs);
  CaseAssessment assessment{definition, std::move(runs), {}, std::move(not_filtered), {}};
  CaseEvidence evidence(assessment.definition, assessment.runs);
  for (const Pair& pair : compared_pairs(definition, assessment.runs))
    for (const std::string& quantity : quantities_of(definition, assessment.runs, pair)) {
      try {
        assessment.comparisons.push_back(evidence.comparison(pair.first, pair.second, quantity));
      } catch (const std::runtime_error& error) {  // ComparisonError and ResultError
        assessment.not_comparable.push_back(
            fmt::format("{} against {}: {}", pair.first, pair.second, error.what()));
      }
    }
  for (const GateRow& row : definition.gate) assessment.gate.push_back(evidence.judge(row));
  assessment.doubts =
      doubt_verdicts(definition, assessment.runs, assessment.comparisons, assessment.gate);
  assessment.fitted = evidence.release_fitted();
  compare_all_fields(assessment);
  return assessment;
}

Standing standing_of(const std::vector<CaseAssessment>& cases) {
  Standing standing;
  for (const CaseAssessment& one : cases) {
    for (const auto& [run, status] : one.runs.status) {
      standing.run_failed |= status.state == RunState::failed;
      standing.left_open |= status.state == RunState::missing;
    }
    standing.left_open |= one.comparisons.empty() && !one.not_comparable.empty();
    for (const GateOutcome& outcome : one.gate) standing.verdicts.push_back(outcome.verdict);
  }
  return standing;
}

int exit_status(const Standing& standing) {
  if (standing.run_failed) return exit_solver_failed;
  const int gated = exit_status_of(standing.verdicts);
  const bool judged = gated == exit_pass || gated == exit_inconclusive;
  return judged && standing.left_open ? exit_not_compared : gated;
}

int exit_status(const std::vector<CaseAssessment>& cases) {
  return exit_status(standing_of(cases));
}

}  // namespace slosh

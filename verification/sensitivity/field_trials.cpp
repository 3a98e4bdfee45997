#include "verification/sensitivity/field_trials.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "verification/case/ensemble.hpp"
#include "verification/case/field_times.hpp"
#include "verification/evidence/case_evidence.hpp"
#include "verification/gate/field_metrics.hpp"
#include "verification/metrics/field_mutation.hpp"
#include "verification/series/sample_moments.hpp"

namespace slosh {
namespace {

constexpr double bound_rounding = 1e-9;  // relative; a value on its bound claims nothing

// The fields at the case's snapshot times, without those of its animation.
std::vector<FieldSnapshot> judged_fields(const CaseDefinition& definition,
                                         const RunResult& result) {
  std::vector<FieldSnapshot> fields;
  for (const double time : definition.snapshot_times)
    if (const FieldSnapshot* field = snapshot_at(definition, result, time))
      fields.push_back(*field);
  return fields;
}

CaseRuns with_fields_alone(const CaseAssessment& assessment) {
  CaseRuns runs{assessment.runs.status, {}};
  for (const auto& [name, result] : assessment.runs.results) {
    RunResult& part = runs.results[name];
    part.case_name = result.case_name;
    part.run_name = result.run_name;
    part.snapshots = judged_fields(assessment.definition, result);
  }
  return runs;
}

std::vector<Mutation> mutations_tried() {
  std::vector<Mutation> mutations;
  for (const auto& [kind, strengths] : graded_mutations())
    if (std::find(std::begin(field_mutations), std::end(field_mutations), kind) !=
        std::end(field_mutations))
      for (const double strength : strengths) mutations.push_back({kind, strength});
  return mutations;
}

// The mean over the judged moments of the candidate's own rms, over P.
double own_rms(const CaseAssessment& assessment, const GateRow& row) {
  const auto& results = assessment.runs.results;
  std::vector<double> values;
  for (const FieldDifference& moment : judged_moments(
           row.mode, results.at(row.candidate), results.at(row.reference), assessment.definition))
    values.push_back(moment.candidate_rms / pressure_under_depth(assessment.definition));
  return mean(values);
}

// What the metric grows by at least beside its value; 0 where that is unknown.
double least_change(const Mutation& mutation, double own_rms) {
  switch (mutation.kind) {
    case MutationKind::louder:
    case MutationKind::quieter:
      return mutation.strength * own_rms;
    case MutationKind::thousandfold:
      return 999 * own_rms;
    case MutationKind::sign_flipped:
      return 2 * own_rms;
    case MutationKind::raised:
    case MutationKind::lowered:
      return mutation.strength;
    default:
      return 0;
  }
}

bool loses_a_judged_moment(const GateRow& row, const CaseDefinition& definition, double s) {
  const std::vector<std::string> names = moment_names(definition);
  const auto kept = static_cast<std::ptrdiff_t>(moments_left(names.size(), s));
  return row.mode == "whole"
             ? kept < std::ssize(names)
             : std::find(names.begin() + kept, names.end(), row.mode) != names.end();
}

bool claims_to_detect(const CaseAssessment& assessment, const GateOutcome& outcome,
                      const Mutation& mutation) {
  const GateRow& row = outcome.row;
  const CaseDefinition& definition = assessment.definition;
  if (mutation.kind == MutationKind::not_a_number) return true;
  if (mutation.kind == MutationKind::truncated)
    return loses_a_judged_moment(row, definition, mutation.strength);
  const bool is_predicted = metric_entry(row.metric).response == MutationResponse::as_field_rms &&
                            !row.improves_on && members_of(definition, row.candidate).size() == 1 &&
                            members_of(definition, row.reference).size() == 1;
  if (!is_predicted) return false;
  const double upper = allowed_by(row).upper;
  return least_change(mutation, own_rms(assessment, row)) - outcome.value.value >
         upper + bound_rounding * std::abs(upper);
}

}  // namespace

MutationTrials try_field_mutations(const CaseAssessment& assessment, const GateOutcome& outcome) {
  const CaseDefinition& definition = assessment.definition;
  const GateRow& row = outcome.row;
  const FieldMutationFrame frame{pressure_under_depth(definition), definition.tank.length};
  const CaseRuns own = with_fields_alone(assessment);
  CaseRuns runs = own;
  const auto verdict_with = [&](const Mutation* mutation) {
    for (const std::string& run : members_of(definition, row.candidate)) {
      const auto found = own.results.find(run);
      if (found == own.results.end()) continue;
      const std::vector<FieldSnapshot>& fields = found->second.snapshots;
      runs.results.at(run).snapshots = mutation ? mutated(fields, *mutation, frame) : fields;
    }
    return CaseEvidence(definition, runs).judge(row).verdict;
  };
  MutationTrials trials{verdict_with(nullptr) == Verdict::pass, {}};
  if (!trials.passes_as_it_is) return trials;
  for (const Mutation& mutation : mutations_tried()) {
    const Verdict verdict = verdict_with(&mutation);
    trials.outcomes.push_back({mutation, claims_to_detect(assessment, outcome, mutation),
                               verdict != Verdict::pass,
                               verdict == Verdict::violated || verdict == Verdict::inconclusive});
  }
  return trials;
}

}  // namespace slosh

#include "verification/sensitivity/mutation_trials.hpp"

#include <algorithm>

namespace slosh {
namespace {

bool moves_the_datum(MutationKind kind) {
  return kind == MutationKind::raised || kind == MutationKind::lowered;
}

// Whether the row's own bound decided the verdict. For a cost it always does: a mutant that no
// longer reaches the error may ask for finer runs, which are not selected or not timed.
bool is_decided_by_bound(const GateRow& row, Verdict verdict) {
  return verdict == Verdict::violated || verdict == Verdict::inconclusive ||
         (is_cost(row.metric) && verdict != Verdict::pass);
}

std::vector<Mutation> mutations_tried(const MutationFrame& frame) {
  std::vector<Mutation> mutations;
  for (const auto& [kind, strengths] : graded_mutations()) {
    if (moves_the_datum(kind) && frame.datum == 0) continue;
    for (const double strength : strengths) mutations.push_back({kind, strength});
  }
  for (const ToneRequest& mode : frame.modes)
    if (mode.refine)
      for (const double strength : {0.02, 0.05, 0.1, 0.2, 0.5})
        mutations.push_back({MutationKind::mode_gained, strength, mode.name});
  for (const ToneRequest& mode : frame.modes)
    if (mode.refine)
      for (const double strength : {0.1, 0.2, 0.5, 1.0, 2.0, 5.0})
        mutations.push_back({MutationKind::mode_damped, strength, mode.name});
  return mutations;
}

}  // namespace

std::vector<GradedMutation> graded_mutations() {
  const std::vector<double> scale{0.01, 0.02, 0.05, 0.1, 0.2},
      shift{0.005, 0.01, 0.02, ten_degrees, 0.05, 0.1},
      frequency{0.001, 0.002, 0.005, 0.01, 0.02, 0.05}, offset{0.005, 0.01, 0.02, 0.05, 0.1},
      drift{0.1, 0.2, 0.5, 1}, chirp{0.02, 0.05, 0.1, 0.2}, noise{0.01, 0.02, 0.05, 0.1, 0.2, 0.5};
  return {{MutationKind::louder, scale},        {MutationKind::quieter, scale},
          {MutationKind::late, shift},          {MutationKind::early, shift},
          {MutationKind::faster, frequency},    {MutationKind::slower, frequency},
          {MutationKind::raised, offset},       {MutationKind::lowered, offset},
          {MutationKind::drifting, drift},      {MutationKind::chirped, chirp},
          {MutationKind::noisy, noise},         {MutationKind::slipped, {1}},
          {MutationKind::truncated, {0.2}},     {MutationKind::not_a_number, {1}},
          {MutationKind::swapped_columns, {1}}, {MutationKind::thousandfold, {1}},
          {MutationKind::other_unit, {1}},      {MutationKind::sign_flipped, {1}}};
}

std::vector<MutationTrials> try_mutations(const std::vector<TriedRow>& rows,
                                          const TimeSeries& candidate, const MutationFrame& frame,
                                          const JudgeRows& judge_rows) {
  std::vector<MutationTrials> trials;
  for (const Verdict verdict : judge_rows(nullptr))
    trials.push_back({verdict == Verdict::pass, {}});
  const auto any_passes = std::any_of(
      trials.begin(), trials.end(), [](const MutationTrials& one) { return one.passes_as_it_is; });
  if (!any_passes) return trials;
  for (const Mutation& mutation : mutations_tried(frame)) {
    const std::vector<Verdict> verdicts = judge_rows(&mutation);
    for (std::size_t i = 0; i < rows.size(); ++i)
      if (trials[i].passes_as_it_is)
        trials[i].outcomes.push_back(
            {mutation,
             claims_to_detect(rows[i].row, {rows[i].measured, candidate}, mutation, frame),
             verdicts[i] != Verdict::pass, is_decided_by_bound(rows[i].row, verdicts[i])});
  }
  return trials;
}

bool detects(const MutationTrials& trials, const Mutation& mutation) {
  return std::any_of(
      trials.outcomes.begin(), trials.outcomes.end(), [&](const MutationOutcome& one) {
        return one.detected && one.mutation.kind == mutation.kind &&
               one.mutation.strength == mutation.strength && one.mutation.mode == mutation.mode;
      });
}

std::optional<double> detected_from(const MutationTrials& trials, MutationKind kind) {
  double missed = -1;
  for (const MutationOutcome& one : trials.outcomes)
    if (one.mutation.kind == kind && !one.detected)
      missed = std::max(missed, one.mutation.strength);
  std::optional<double> from;
  for (const MutationOutcome& one : trials.outcomes)
    if (one.mutation.kind == kind && one.mutation.strength > missed)
      from = std::min(from.value_or(one.mutation.strength), one.mutation.strength);
  return from;
}

bool was_tried(const MutationTrials& trials, MutationKind kind) {
  return std::any_of(trials.outcomes.begin(), trials.outcomes.end(),
                     [&](const MutationOutcome& one) { return one.mutation.kind == kind; });
}

std::vector<Mutation> broken_claims(const MutationTrials& trials) {
  std::vector<Mutation> broken;
  for (const MutationOutcome& one : trials.outcomes)
    if (one.claimed && !one.detected) broken.push_back(one.mutation);
  return broken;
}

bool detects_no_change(const MutationTrials& trials) {
  return trials.passes_as_it_is && std::none_of(trials.outcomes.begin(), trials.outcomes.end(),
                                                [](const MutationOutcome& one) {
                                                  return one.judged &&
                                                         changes_values(one.mutation.kind);
                                                });
}

}  // namespace slosh

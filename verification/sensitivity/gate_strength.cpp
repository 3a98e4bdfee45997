#include "verification/sensitivity/gate_strength.hpp"

#include <algorithm>

namespace slosh {
namespace {

struct Ladder {
  MutationKind kind;
  std::vector<double> strengths;
};

std::vector<Ladder> ladders() {
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

bool moves_the_datum(MutationKind kind) {
  return kind == MutationKind::raised || kind == MutationKind::lowered;
}

// A cost that the runs of this form do not reach any more is of the row's own bound, though the
// finer runs that would tell it be not selected or not timed.
bool is_of_a_bound(const GateRow& row, Verdict verdict) {
  return verdict == Verdict::violated || verdict == Verdict::inconclusive ||
         (row.metric == Metric::cost_to_reach && verdict != Verdict::pass);
}

}  // namespace

std::vector<Mutation> mutations_tried(const MutationFrame& frame) {
  std::vector<Mutation> mutations;
  for (const auto& [kind, strengths] : ladders()) {
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

std::vector<GateStrength> gate_strengths(const std::vector<TriedRow>& rows,
                                         const TimeSeries& candidate, const MutationFrame& frame,
                                         const JudgeRows& judge_rows) {
  std::vector<GateStrength> strengths;
  for (const Verdict verdict : judge_rows(nullptr))
    strengths.push_back({verdict == Verdict::pass, {}});
  const auto any_passes = std::any_of(strengths.begin(), strengths.end(),
                                      [](const GateStrength& one) { return one.passes_as_it_is; });
  if (!any_passes) return strengths;
  for (const Mutation& mutation : mutations_tried(frame)) {
    const std::vector<Verdict> verdicts = judge_rows(&mutation);
    for (std::size_t i = 0; i < rows.size(); ++i)
      if (strengths[i].passes_as_it_is)
        strengths[i].outcomes.push_back(
            {mutation,
             claims_to_detect(rows[i].row, {rows[i].measured, candidate}, mutation, frame),
             verdicts[i] != Verdict::pass, is_of_a_bound(rows[i].row, verdicts[i])});
  }
  return strengths;
}

bool detects(const GateStrength& strength, const Mutation& mutation) {
  return std::any_of(
      strength.outcomes.begin(), strength.outcomes.end(), [&](const MutationOutcome& one) {
        return one.detected && one.mutation.kind == mutation.kind &&
               one.mutation.strength == mutation.strength && one.mutation.mode == mutation.mode;
      });
}

std::optional<double> detected_from(const GateStrength& strength, MutationKind kind) {
  double missed = -1;
  for (const MutationOutcome& one : strength.outcomes)
    if (one.mutation.kind == kind && !one.detected)
      missed = std::max(missed, one.mutation.strength);
  std::optional<double> from;
  for (const MutationOutcome& one : strength.outcomes)
    if (one.mutation.kind == kind && one.mutation.strength > missed)
      from = std::min(from.value_or(one.mutation.strength), one.mutation.strength);
  return from;
}

std::vector<Mutation> broken_claims(const GateStrength& strength) {
  std::vector<Mutation> broken;
  for (const MutationOutcome& one : strength.outcomes)
    if (one.claimed && !one.detected) broken.push_back(one.mutation);
  return broken;
}

bool detects_no_change(const GateStrength& strength) {
  return strength.passes_as_it_is &&
         std::none_of(strength.outcomes.begin(), strength.outcomes.end(),
                      [](const MutationOutcome& one) {
                        return one.judged && changes_values(one.mutation.kind);
                      });
}

}  // namespace slosh

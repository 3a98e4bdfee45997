#include "verification/gate/gate_strength.hpp"

namespace slosh {
namespace {

struct Ladder {
  MutationKind kind;
  std::vector<double> strengths;
};

std::vector<Ladder> ladders() {
  const std::vector<double> scale{0.01, 0.02, 0.05, 0.1, 0.2}, shift{0.005, 0.01, 0.02, 0.05, 0.1},
      frequency{0.001, 0.002, 0.005, 0.01, 0.02, 0.05}, noise{0.01, 0.02, 0.05, 0.1, 0.2, 0.5};
  return {{MutationKind::louder, scale},        {MutationKind::quieter, scale},
          {MutationKind::late, shift},          {MutationKind::early, shift},
          {MutationKind::faster, frequency},    {MutationKind::slower, frequency},
          {MutationKind::noisy, noise},         {MutationKind::slipped, {1}},
          {MutationKind::truncated, {0.2}},     {MutationKind::not_a_number, {1}},
          {MutationKind::swapped_columns, {1}}, {MutationKind::thousandfold, {1}},
          {MutationKind::other_unit, {1}},      {MutationKind::sign_flipped, {1}}};
}

}  // namespace

std::vector<Mutation> mutations_tried() {
  std::vector<Mutation> mutations;
  for (const auto& [kind, strengths] : ladders())
    for (const double strength : strengths) mutations.push_back({kind, strength});
  return mutations;
}

GateStrength gate_strength(const GateRow& row, const JudgedCandidate& candidate,
                           const MutationFrame& frame, const PassesWith& passes_with) {
  GateStrength result{passes_with(nullptr), {}};
  if (!result.passes_as_it_is) return result;
  for (const Mutation& mutation : mutations_tried())
    result.outcomes.push_back(
        {mutation, claims_to_detect(row, candidate, mutation, frame), !passes_with(&mutation)});
  return result;
}

std::optional<double> detected_from(const GateStrength& strength, MutationKind kind) {
  std::optional<double> from;
  for (const MutationOutcome& outcome : strength.outcomes) {
    if (outcome.mutation.kind != kind) continue;
    if (!outcome.detected)
      from.reset();
    else if (!from)
      from = outcome.mutation.strength;
  }
  return from;
}

std::vector<Mutation> broken_claims(const GateStrength& strength) {
  std::vector<Mutation> broken;
  for (const auto& [mutation, claimed, detected] : strength.outcomes)
    if (claimed && !detected) broken.push_back(mutation);
  return broken;
}

}  // namespace slosh

// What a gate row can detect, found out by judging its real candidate made wrong on purpose
// (series_mutation.hpp): every graded kind over a ladder of strengths, every other one once, and
// beside each whether the row must detect it (gate_claims.hpp). A row whose limit is wide shows it
// by the strengths it lets pass; a judge that does not judge shows it by claims that are not kept.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "verification/gate/gate_claims.hpp"

namespace slosh {

// Whether the row passes with its candidate made wrong by this mutation, every member of an
// ensemble alike; null: as it is. Anything else than a pass (violated, not compared) is false.
using PassesWith = std::function<bool(const Mutation* mutation)>;

struct MutationOutcome {
  Mutation mutation;
  bool claimed;   // the row must not pass
  bool detected;  // the row does not pass
};

struct GateStrength {
  bool passes_as_it_is;
  // By kind, strengths increasing; none of a row that does not pass as it is, as it would not pass
  // with anything.
  std::vector<MutationOutcome> outcomes;
};

// All that are tried: scale 1 to 20 %, shift 0.5 to 10 % of a period, frequency 0.1 to 5 %, noise 1
// to 50 % of the values' standard deviation.
std::vector<Mutation> mutations_tried();

// Throws ComparisonError as cut_to_window() does of the candidate, and what passes_with throws.
GateStrength gate_strength(const GateRow& row, const JudgedCandidate& candidate,
                           const MutationFrame& frame, const PassesWith& passes_with);

// The smallest strength tried from which on every one is detected; none where the strongest is not.
std::optional<double> detected_from(const GateStrength& strength, MutationKind kind);

// Claimed, but not detected.
std::vector<Mutation> broken_claims(const GateStrength& strength);

}  // namespace slosh

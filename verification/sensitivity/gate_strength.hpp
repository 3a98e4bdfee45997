// What a gate row can detect, found out by judging its real candidate made wrong on purpose
// (series_mutation.hpp): every graded kind over a ladder of strengths, every other one once, and
// beside each whether the row must detect it (gate_claims.hpp). A row whose limit is wide shows it
// by the strengths it lets pass; a judge that does not judge shows it by claims that are not kept.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "verification/gate/gate.hpp"
#include "verification/sensitivity/gate_claims.hpp"

namespace slosh {

// [periods]: the lag that a case's rows must detect together (case_coverage.hpp).
inline constexpr double ten_degrees = 10.0 / 360;

// A row and its metric of its candidate as it is, in the row's unit.
struct TriedRow {
  GateRow row;
  double measured;
};

// The verdict of each of the tried rows with its candidate as it is (null) or mutated, every member
// of an ensemble alike.
using JudgeRows = std::function<std::vector<Verdict>(const Mutation*)>;

struct MutationOutcome {
  Mutation mutation;
  bool claimed;            // the row must not pass
  bool detected;           // the row does not pass
  bool judged = detected;  // by its own bound, not for want of something to compare
};

struct GateStrength {
  bool passes_as_it_is;
  // By kind, strengths increasing; none of a row that does not pass as it is, as it would not pass
  // with anything.
  std::vector<MutationOutcome> outcomes;
};

// All that are tried: scale 1 to 20 %, shift 0.5 to 10 % of a period, frequency 0.1 to 5 %, an
// offset of 0.5 to 10 % of the datum, a drift of 10 to 100 % of the values' standard deviation, a
// chirp of 2 to 20 % of a period, each natural mode gained by 2 to 50 % and damped 1.1 to 6 times
// as fast, noise of 1 to 50 % of the deviation.
std::vector<Mutation> mutations_tried(const MutationFrame& frame);

// Of rows that judge one candidate in one frame, in their order: each mutant is judged by all of
// them together. Throws as mutated() does of the candidate, and what judge_rows throws.
std::vector<GateStrength> gate_strengths(const std::vector<TriedRow>& rows,
                                         const TimeSeries& candidate, const MutationFrame& frame,
                                         const JudgeRows& judge_rows);

// Whether the row does not pass with exactly this mutation; false where it was not tried.
bool detects(const GateStrength& strength, const Mutation& mutation);

// The smallest strength tried from which on every one is detected; none where the strongest is not.
std::optional<double> detected_from(const GateStrength& strength, MutationKind kind);

// Claimed, but not detected.
std::vector<Mutation> broken_claims(const GateStrength& strength);

// Whether the row passes as it is and its bound is kept by every change of its candidate's values
// that was tried: it judges nothing, whatever its limit says.
bool detects_no_change(const GateStrength& strength);

}  // namespace slosh

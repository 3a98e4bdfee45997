// Mutation testing of gate rows: the rows judge their real candidate made wrong on purpose
// (series_mutation.hpp), every graded kind of mutation at increasing strengths and every other kind
// once. Each outcome also says whether the row must detect the mutation (gate_claims.hpp). A row
// with a wide limit lets strong mutations pass; a defective judge breaks claims.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "verification/gate/gate.hpp"
#include "verification/sensitivity/gate_claims.hpp"

namespace slosh {

// [periods] The lag that the rows of every case must detect together (case_coverage.hpp).
inline constexpr double ten_degrees = 10.0 / 360;

// A kind of mutation and the strengths at which it is tried.
struct GradedMutation {
  MutationKind kind;
  std::vector<double> strengths;  // increasing
};

// All kinds but those of natural modes.
std::vector<GradedMutation> graded_mutations();

// A row, and the metric of its candidate as it is, in the row's unit.
struct TriedRow {
  GateRow row;
  double measured;
};

// Returns the verdict of each tried row with its candidate as it is (nullptr) or mutated; all
// members of an ensemble are mutated alike.
using JudgeRows = std::function<std::vector<Verdict>(const Mutation*)>;

struct MutationOutcome {
  Mutation mutation;
  bool claimed;            // the row must not pass
  bool detected;           // the row does not pass
  bool judged = detected;  // the row's own bound decided, and not a failed comparison
};

// The outcomes of all mutations of one row's candidate.
struct MutationTrials {
  bool passes_as_it_is;
  // By kind, in increasing strength. Empty where the row does not pass as it is: it would then not
  // pass with any mutation.
  std::vector<MutationOutcome> outcomes;
};

// Tries mutations on rows that judge one candidate in one frame, and returns their trials in the
// order of the rows. The strengths are: scale 1 to 20 %, shift 0.5 to 10 % of a period, frequency
// 0.1 to 5 %, an offset of 0.5 to 10 % of the datum, a drift of 10 to 100 % of the values' standard
// deviation, a chirp of 2 to 20 % of a period, each natural mode amplified by 2 to 50 % and damped
// 1.1 to 6 times as fast, noise of 1 to 50 % of the deviation. Throws what mutated() throws for the
// candidate, and what judge_rows throws.
std::vector<MutationTrials> try_mutations(const std::vector<TriedRow>& rows,
                                          const TimeSeries& candidate, const MutationFrame& frame,
                                          const JudgeRows& judge_rows);

// Whether the row does not pass with exactly this mutation. Returns false where it was not tried.
bool detects(const MutationTrials& trials, const Mutation& mutation);

// The smallest strength from which on every strength that was tried is detected. Returns nullopt
// where the strongest one is not.
std::optional<double> detected_from(const MutationTrials& trials, MutationKind kind);

// Whether any strength of the kind was tried. A row that does not pass as it is has no trials.
bool was_tried(const MutationTrials& trials, MutationKind kind);

// The mutations that were claimed and not detected.
std::vector<Mutation> broken_claims(const MutationTrials& trials);

// Whether the row passes as it is and its bound holds for every change of its candidate's values
// that was tried. Such a row judges nothing, whatever its limit.
bool detects_no_change(const MutationTrials& trials);

}  // namespace slosh

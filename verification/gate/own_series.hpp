// What a row on a peak of the candidate says beside its value: when the peak occurs, and what a
// single run leaves open.
#pragma once

#include <string>

#include "verification/gate/gate_evidence.hpp"
#include "verification/gate/three_way_verdict.hpp"

namespace slosh {

// "; at 1.71 s of 0 to 12 s": when the largest magnitude occurs and over which time it is sought,
// of an ensemble that of its highest member; followed by a larger value that the run has at another
// time. Of noise the time alone. Returns "" for any other metric. Throws as the evidence
// does.
std::string place_text(const GateRow& row, const GateEvidence& evidence);

// What one run leaves open. A row that rests on a single run of a simulation says so where the
// metric is a peak of a compared quantity or of an impact. It does not pass where the peak is an
// impact and a bound lies within the scatter of others, that of the experiment's published repeats
// or else a factor of 2: of the 102 repeats of each water impact of SPHERIC's benchmark 10 one
// exceeds another by a factor of 1.6 to 2.1 in 5 % of all pairs. A peak is an impact where the
// series stays above nine tenths of it for less than 0.03 of the wave's period, a fifth of the time
// for which the crest of a sine does.
RowDoubts single_run_doubts(const GateRow& row, double value, const AllowedRange& allowed,
                            const GateEvidence& evidence);

}  // namespace slosh

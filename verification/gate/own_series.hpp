// What a row on a peak of the candidate says beside its value.
#pragma once

#include <string>

#include "verification/gate/gate_evidence.hpp"

namespace slosh {

// "; at 1.71 s of 0 to 12 s": when the largest magnitude occurs and over which time it is sought,
// of an ensemble that of its highest member; a larger one that the run has at another time; and, of
// a compared quantity or an impact, that the peak rests on a single run of a simulation. Returns ""
// for any other metric. Throws as the evidence does.
std::string peak_text(const GateRow& row, const GateEvidence& evidence);

}  // namespace slosh

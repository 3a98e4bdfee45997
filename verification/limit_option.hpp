// A limit as a command line gives it, "phase_lag=2" or "natural_1:frequency_error=0.01", in the
// metric's unit; judged as a gate row of a case is.
#pragma once

#include <string>

#include "verification/gate/gate.hpp"
#include "verification/metrics/comparison.hpp"

namespace slosh {

// Of a metric that has modes "forced" where none is named. Throws CaseFileError for what is no such
// limit.
GateOutcome judged_by_limit(const std::string& limit, const Comparison& comparison);

}  // namespace slosh

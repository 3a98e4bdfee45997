// Limits on a command line, "phase_lag=2" or "natural_1:frequency_error=0.01", in the metric's
// unit. They obey the same table of metrics as the gate rows of a case (metric_table.hpp): it says
// on which modes a metric is measured, and how wide a limit may be.
#pragma once

#include <string>
#include <vector>

#include "verification/gate/gate.hpp"
#include "verification/metrics/comparison.hpp"

namespace slosh {

// One outcome for each limit, judged as a gate row of a case is. A metric that can be measured on
// the forced mode is measured there where no mode is named. A limit that holds is inconclusive
// where there are doubts of the runs themselves. Throws CaseFileError for what is no such limit and
// for a second one on the same metric and mode.
std::vector<GateOutcome> judged_by_limits(const std::vector<std::string>& limits,
                                          const Comparison& comparison,
                                          const std::vector<std::string>& doubts_of_runs);

}  // namespace slosh

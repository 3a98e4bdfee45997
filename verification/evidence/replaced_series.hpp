// A gate row measured once more with another series in the place of what one of its runs left.
#pragma once

#include "verification/case/case_definition.hpp"
#include "verification/evidence/case_runs.hpp"
#include "verification/gate/gate.hpp"

namespace slosh {

// The row's metric where `run`, its candidate or its reference, has this series of the row's
// quantity. Throws as measured() does.
Estimate measured_with(const CaseDefinition& definition, const CaseRuns& runs, const GateRow& row,
                       const std::string& run, const TimeSeries& series);

}  // namespace slosh

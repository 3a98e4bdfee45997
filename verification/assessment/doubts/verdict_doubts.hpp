// What the verdicts of a case rest on or leave unsaid, beyond what each row measures.
#pragma once

#include <string>
#include <vector>

#include "verification/case/case_definition.hpp"
#include "verification/evidence/case_runs.hpp"
#include "verification/gate/gate.hpp"
#include "verification/metrics/comparison.hpp"

namespace slosh {

// Adds to the remarks of the rows, and marks as doubtful,
//   a load or a frequency that is judged without a reference while an effect that the models leave
//   out exceeds its limit (model_limits.hpp): no reference shows what it does;
//   a mode that passes while the whole series departs from the reference by more than half of its
//   deviation (normalised rms), where no row of this pair on normalised_rms, aligned_rms or
//   outside_band judges that.
// Adds to the message of a natural mode's frequency that of linear theory.
// Returns what stands below the headline, "doubtful: CASE: ...": those and the runs that are not
// sound.
std::vector<std::string> doubt_verdicts(const CaseDefinition& definition, const CaseRuns& runs,
                                        const std::vector<Comparison>& comparisons,
                                        std::vector<GateOutcome>& gate);

}  // namespace slosh

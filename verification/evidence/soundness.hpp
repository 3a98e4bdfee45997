// Whether a run of a simulation is sound, by what it has recorded of itself. This is the one place
// that decides it; rows of validation on a run that is not sound do not pass.
#pragma once

#include <set>
#include <string>

#include "verification/case/case_definition.hpp"
#include "verification/evidence/case_runs.hpp"

namespace slosh {

// "recommended_10mm is not sound: its Mach number but for 5 % of the time is 0.42, limit 0.2" of
// each such run of these names, of an ensemble its first, joined by "; "; "" where all that have
// results are sound over the case's window and from their start to its end. A run with a NaN is
// not. Without gravity the tension has no scale and is not judged. The volume of the liquid and the
// log of OpenFOAM are checked as it runs: such a run fails (openfoam_cases/run_case.hpp).
std::string soundness_doubt(const CaseDefinition& definition, const CaseRuns& runs,
                            const std::set<std::string>& named);

// "its Mach number but for 5 % of the time is 0.42, limit 0.2", the same of one result over a
// window.
std::string soundness_doubts(const RunResult& result, TimeWindow window, bool has_gravity);

// "doubtful: CASE: " and that of the runs that the case's rows judge, each over the row's time; ""
// where they are sound.
std::string doubtful_runs(const CaseDefinition& definition, const CaseRuns& runs);

}  // namespace slosh

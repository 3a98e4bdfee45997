// Whether a run of a simulation is sound, by what it has recorded of itself. This is the one place
// that decides it; rows of validation on a run that is not sound do not pass.
#pragma once

#include <set>
#include <string>

#include "verification/case/case_definition.hpp"
#include "verification/evidence/case_runs.hpp"

namespace slosh {

// "recommended_10mm is not sound: its Mach number is 0.42, limit 0.2; nor is recommended_10mm_3" of
// the runs of these names, all members of an ensemble; "" where all that have results are sound.
//   mach_number    of the fastest particle, at most 0.2: the density of a weakly compressible
//   liquid
//                  differs by its square (Monaghan 1994, J. Comput. Phys. 110:399), here 4 %
//   density_error  of one particle, at most 5 %: those 4 %, and 1 % under the weight of a column at
//                  sound_speed_ratio = 10
//   packing_drift  at most 1 %: a liquid that keeps its volume keeps its kernel sum
//   tension_share  at most half of the particles: under gas a liquid parts where its pressure falls
//                  below the gas's. Without gravity the tension has no scale and is not judged.
//   Courant number of OpenFOAM at most 1: its limited flux is explicit
// A series may be beyond its limit at 5 % of its samples, as drops and impacts are short, and where
// a sample is NaN the run is not sound. The volume of the liquid and the log of OpenFOAM are
// checked as it runs: such a run fails (openfoam_cases/run_case.hpp).
std::string soundness_doubt(const CaseDefinition& definition, const CaseRuns& runs,
                            const std::set<std::string>& named);

// "doubtful: CASE: " and that of the runs that the case's rows judge; "" where they are sound.
std::string doubtful_runs(const CaseDefinition& definition, const CaseRuns& runs);

}  // namespace slosh

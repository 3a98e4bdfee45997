// Whether a run of a simulation is sound, by what it has recorded of itself. This is the one place
// that decides it; rows of validation on a run that is not sound do not pass.
//   Mach number     at most 0.2 of any particle of SPH: the density of a weakly compressible liquid
//                   differs by its square (Monaghan 1994, J. Comput. Phys. 110:399), here 4 %
//   density error   at most 5 % of any particle: those 4 %, and 1 % under the weight of a column at
//                   sound_speed_ratio = 10
//   packing drift   at most 1 %: a liquid that keeps its volume keeps its kernel sum
//   tension share   at most half of the particles: under gas a liquid parts where its pressure
//   falls
//                   below the gas's
//   wall pressure   no lower than minus the pressure under the fill depth, of SPH and OpenFOAM;
//                   interFoam's lowest in breaking waves is a thirtieth of that
//   Courant number  at most 1 of OpenFOAM, whose limited flux is explicit
// The volume of the liquid and the log of OpenFOAM are checked as it runs: such a run fails
// (openfoam_cases/run_case.hpp). A number that is NaN is not sound. Without gravity the tension has
// no scale and is not judged. A program of the user's records none of these.
#pragma once

#include <string>

#include "verification/case/case_definition.hpp"
#include "verification/evidence/case_runs.hpp"

namespace slosh {

// "recommended_10mm is not sound: its largest Mach number is 0.42, limit 0.2; ..."; "" for a run
// that is sound, is no simulation or has no result.
std::string soundness_doubt(const CaseDefinition& definition, const CaseRuns& runs,
                            const std::string& run);

// "doubtful: CASE: recommended_10mm is not sound: ...; so are 2 of its other runs" of the case's
// first such run; "" where every run is sound.
std::string doubtful_runs(const CaseDefinition& definition, const CaseRuns& runs);

}  // namespace slosh

// A case as the tank that interFoam or a program of its family solves.
#pragma once

#include "openfoam_cases/sloshing_tank.hpp"
#include "verification/case/case_definition.hpp"

namespace slosh {

// Returns the tank in the run's cells. check_tank.hpp of openfoam_cases tells whether it can be
// solved.
openfoam::SloshingTank interfoam_tank(const InterFoamRun& run, const CaseDefinition& definition);

}  // namespace slosh

// Executes one run of a case in this process: translates the case for the solver, runs it, and puts
// what it gives into a result. Series: the case's quantities (quantities.hpp) as far as the solver
// has them; of SPH also "kinetic_energy", "potential_energy" [J/m] and, of still water, those of
// sph/still_water.hpp; of interFoam also "liquid_volume" [m2]; of a record its own quantity alone;
// of an external program those that the case declares. Of potential flow each also with the suffix
// `coarser`, from a run of fewer nodes. SPH and interFoam leave snapshots at the case's times.
#pragma once

#include <string>

#include "verification/case/case_definition.hpp"
#include "verification/results/result_file.hpp"
#include "verification/results/run_failure.hpp"
#include "verification/solvers/run_request.hpp"

namespace slosh {

// Throws CaseFileError (file:line) for what execute() would refuse of a case but for a record that
// is not supplied (an unknown scheme, a spacing that does not fit the tank, a dam for linear
// theory): for whoever wants to know before anything runs.
void require_runnable(const CaseDefinition& definition, const RunDefinition& run);

// Throws CaseFileError (file:line) for an unknown scheme, anything else that the solver
// does not take, snapshots that it cannot make and a record that is not supplied, SolverError, and
// ResultError where a snapshot cannot be written.
RunResult execute(const CaseDefinition& definition, const RunDefinition& run,
                  const RunSettings& settings, const Progress& progress);

}  // namespace slosh

// Executes one run of a case in this process: it translates the case for the solver, runs it, and
// collects its output in a result. The series are
//   of every solver        the case's quantities (quantities.hpp), as far as the solver has them
//   SPH, also              "kinetic_energy" and "potential_energy" [J/m], those of
//                          sph/recording/soundness.hpp, and of still water those of
//                          sph/recording/still_water.hpp
//   interFoam, also        "liquid_volume" [m2]
//   potential flow, also   each series with the suffix `coarser`, from a run with fewer nodes
//   linear theory, also    each series with the suffix `finer`, with more modes, and, where it is
//                          finite, with `nonlinear`: an estimate of the third order
//                          (beyond_linear.hpp)
//   the viscous wave, also the last of these
//   a record               its own quantity, and the edges of its band
//   an external program    those that the case declares
// A pressure whose gauge has a filter is there filtered too (filtered_pressures.hpp). SPH and
// interFoam leave snapshots at the case's times.
#pragma once

#include <string>

#include "verification/case/case_definition.hpp"
#include "verification/results/result_file.hpp"
#include "verification/results/run_failure.hpp"
#include "verification/solvers/solver_runs.hpp"

namespace slosh {

// Checks a run before anything runs: throws CaseFileError (file:line) for whatever execute() would
// refuse (an unknown scheme, a spacing that does not fit the tank, a dam for linear theory), except
// a record that is not supplied.
void require_runnable(const CaseDefinition& definition, const RunDefinition& run);

// Throws CaseFileError (file:line) where the row's candidate, or its reference, leaves no series of
// the row's quantity, whatever happens in the run.
void require_series(const CaseDefinition& definition, const GateRow& row);

// Executes the run and returns its result. Throws CaseFileError (file:line) for a case or settings
// that the solver does not take and for a record that is not supplied, SolverError where the solver
// fails, and ResultError where a snapshot cannot be written.
RunResult execute(const CaseDefinition& definition, const RunDefinition& run,
                  const RunSettings& settings, const Progress& progress);

}  // namespace slosh

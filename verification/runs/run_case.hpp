// Executes one run of a case in this process: translates the case for the solver, runs it, and puts
// what it gives into a result. Series: the case's quantities (quantities.hpp) as far as the solver
// has them; of SPH also "kinetic_energy", "potential_energy" [J/m] and, of still water, those of
// sph/still_water.hpp; of interFoam also "liquid_volume" [m2]; of a record its own quantity alone;
// of an external program those that the case declares. Of potential flow each also with the suffix
// `coarser`, from a run of fewer nodes. SPH and interFoam leave snapshots at the case's times.
#pragma once

#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>

#include "verification/case_file/case_definition.hpp"
#include "verification/runs/result_file.hpp"
#include "verification/runs/run_failure.hpp"

namespace slosh {

// The solver failed, could not use its directories, or left less than the whole duration or values
// that are no numbers. what() says how.
struct SolverError : std::runtime_error {
  explicit SolverError(const std::string& message)
      : SolverError({"solver failed", message, "", ""}) {}
  // what() is the message, the log in brackets, and the details below.
  explicit SolverError(const RunFailure& why);

  RunFailure failure;
};

inline constexpr const char* coarser = "/coarser";

struct RunSettings {
  std::filesystem::path work_directory;  // for OpenFOAM's case, an external program's files and the
                                         // snapshots; made if need be
  std::filesystem::path openfoam_templates;  // openfoam_cases/sloshing_tank
  // [s], of an SPH run, a multiple of the sample interval; 0: no snapshots
  double snapshot_interval = 0;
  // [s], of an SPH run, a multiple of the sample interval: how often its state is saved in the work
  // directory (state_file.hpp); 0: never
  double state_interval = 0;
  std::filesystem::path resume =
      {};                 // the state that an SPH run goes on from; empty: from the start
  double time_limit = 0;  // [s] of wall time, of an interFoam run; 0: none
  std::string key;        // run_key()'s, recorded
  std::string command;    // repeats this run, recorded
};

// Called now and then with the simulated time [s] and the steps so far.
using Progress = std::function<void(double time, double steps)>;

// As case files name it: "sph", "interfoam", "linear", "viscous_wave", "potential" or "record".
std::string solver_name(const RunDefinition& run);

// What an SPH run starts as.
struct SphOutline {
  std::size_t particles;                  // of the liquid
  std::vector<std::string> active_terms;  // the physics compiled in
};
// Found by making the start; throws CaseFileError as require_runnable().
SphOutline sph_outline(const CaseDefinition& definition, const RunDefinition& run);

// What is missing where a record is not supplied.
std::string where_to_get(const RecordRun& record, const CaseDefinition& definition);

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

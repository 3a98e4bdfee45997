// The runners of all solvers, and the choice among them: the second half of the table of solver
// kinds, whose first is verification/case/solver_kinds.hpp.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "verification/case/case_definition.hpp"
#include "verification/input/case_file_error.hpp"
#include "verification/results/result_file.hpp"
#include "verification/results/run_failure.hpp"

namespace slosh {

// What a solver is asked for.
struct RunSettings {
  // For OpenFOAM's case, an external program's files and the snapshots; it is made if need be.
  std::filesystem::path work_directory;
  std::filesystem::path openfoam_templates;  // openfoam_cases/sloshing_tank
  // [s], of an SPH run, a multiple of the sample interval; 0: no snapshots
  double snapshot_interval = 0;
  // [s], of an SPH run, a multiple of the sample interval: how often its state is saved in the work
  // directory (state_file.hpp); 0: never
  double state_interval = 0;
  std::filesystem::path resume = {};  // the state that an SPH run restarts from; empty: none
  double time_limit = 0;              // [s] of wall time, of an interFoam run; 0: none
  std::string key;                    // run_key()'s, recorded
  std::string command;                // repeats this run, recorded
  bool with_left_out = true;          // of a theory: also its series that SolverKind::leaves names
};

// Called from time to time with the simulated time [s] and the number of steps so far.
using Progress = std::function<void(double time, double steps)>;

struct RunRequest {
  const CaseDefinition& definition;
  const RunDefinition& run;
  const RunSettings& settings;
  const Progress& progress;
};

// Throws CaseFileError (file:line) where the run's solver does not take the case.
void require_scene(const CaseDefinition& definition, const RunDefinition& run);

// Executes the run with its own solver.
RunResult run_solver(const RunRequest& request);

// One pair of functions for each kind of solver, in its file NAME_run.cpp.
//
// require_scene throws CaseFileError (file:line) unless the solver takes the case. SPH's scheme
// must be one of sph/'s; linear theory knows the whole liquid of a tank without obstacles that
// moves or has an initial wave, and the viscous wave's theory a still tank under such a wave;
// the series of an external program must be of known formats, and its placeholders known.
//
// run_solver returns the result's series, active terms, diagnostics, steps and elements, and what
// only the solver knows of the provenance. The times of its cost are those that it spent on other
// things than the run, such as asking a program for its version. It throws the leaf's own
// exceptions, and std::invalid_argument for a case that the solver does not take.
void require_scene(const SphRun& sph, const CaseDefinition& definition, const RunDefinition& run);
RunResult run_solver(const SphRun& sph, const RunRequest& request);

void require_scene(const InterFoamRun& interfoam, const CaseDefinition& definition,
                   const RunDefinition& run);
RunResult run_solver(const InterFoamRun& interfoam, const RunRequest& request);

void require_scene(const LinearRun& linear, const CaseDefinition& definition,
                   const RunDefinition& run);
RunResult run_solver(const LinearRun& linear, const RunRequest& request);

void require_scene(const PotentialRun& potential, const CaseDefinition& definition,
                   const RunDefinition& run);
RunResult run_solver(const PotentialRun& potential, const RunRequest& request);

void require_scene(const ViscousWaveRun& viscous, const CaseDefinition& definition,
                   const RunDefinition& run);
RunResult run_solver(const ViscousWaveRun& viscous, const RunRequest& request);

void require_scene(const RecordRun& record, const CaseDefinition& definition,
                   const RunDefinition& run);
RunResult run_solver(const RecordRun& record, const RunRequest& request);

void require_scene(const ExternalRun& external, const CaseDefinition& definition,
                   const RunDefinition& run);
RunResult run_solver(const ExternalRun& external, const RunRequest& request);

void require_scene(const StoredRun& stored, const CaseDefinition& definition,
                   const RunDefinition& run);
// The whole cost of the result is what the code took elsewhere.
RunResult run_solver(const StoredRun& stored, const RunRequest& request);

// The files that a stored result is read from.
std::vector<std::filesystem::path> stored_files(const StoredRun& stored);

// What an SPH run starts as.
struct SphOutline {
  std::size_t particles;                  // of the liquid
  std::vector<std::string> active_terms;  // the physics compiled in
  double estimated_speed = 0;             // the largest of the liquid, as estimated [m/s]
};
// Makes the start to find the outline; throws CaseFileError as require_scene() does.
SphOutline sph_outline(const CaseDefinition& definition, const RunDefinition& run);

// Says what is missing where a record is not supplied.
std::string where_to_get(const RecordRun& record, const CaseDefinition& definition);

// Makes the error of a run that does not take its case or settings.
CaseFileError refused(const RunDefinition& run, const std::string& why);

}  // namespace slosh

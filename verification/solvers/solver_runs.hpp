// One run by each solver, and the choice among them. Each returns the result's series, active
// terms, diagnostics, steps and elements, and what only it knows of the provenance; exceptions are
// the leaf's own, std::invalid_argument for a case that it does not take.
#pragma once

#include "verification/input/case_file_error.hpp"
#include "verification/results/result_file.hpp"
#include "verification/results/run_failure.hpp"
#include "verification/solvers/run_request.hpp"

namespace slosh {

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

// What a run says that does not take its case or settings.
CaseFileError refused(const RunDefinition& run, const std::string& why);

// Throws CaseFileError (file:line) unless the solver takes the case: SPH's scheme must be one of
// sph/'s, linear theory knows the whole liquid of a tank without obstacles that moves or has an
// initial wave, that of the viscous wave one that stands under such a wave; the series of an
// external program must be of known formats and its placeholders known.
void require_scene(const SphRun& sph, const CaseDefinition& definition, const RunDefinition& run);
void require_scene(const InterFoamRun& interfoam, const CaseDefinition& definition,
                   const RunDefinition& run);
void require_scene(const LinearRun& linear, const CaseDefinition& definition,
                   const RunDefinition& run);
void require_scene(const PotentialRun& potential, const CaseDefinition& definition,
                   const RunDefinition& run);
void require_scene(const ViscousWaveRun& viscous, const CaseDefinition& definition,
                   const RunDefinition& run);
void require_scene(const RecordRun& record, const CaseDefinition& definition,
                   const RunDefinition& run);

void require_scene(const ExternalRun& external, const CaseDefinition& definition,
                   const RunDefinition& run);

// Throws CaseFileError (file:line) where the run's solver does not take the case.
void require_scene(const CaseDefinition& definition, const RunDefinition& run);

// By the run's own solver.
RunResult run_solver(const RunRequest& request);

RunResult run_sph(const SphRun& sph, const RunRequest& request);
RunResult run_interfoam(const InterFoamRun& interfoam, const RunRequest& request);
RunResult run_linear(const LinearRun& linear, const RunRequest& request);
RunResult run_potential(const PotentialRun& potential, const RunRequest& request);
RunResult run_viscous_wave(const RunRequest& request);
RunResult run_record(const RecordRun& record, const RunRequest& request);
RunResult run_external(const ExternalRun& external, const RunRequest& request);

}  // namespace slosh

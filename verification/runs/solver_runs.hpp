// One run by each solver: what run_case.cpp chooses from. Each returns the result's series, active
// terms, diagnostics, steps and elements, and what only it knows of the provenance; exceptions are
// the leaf's own.
#pragma once

#include "verification/runs/run_case.hpp"

namespace slosh {

struct RunRequest {
  const CaseDefinition& definition;
  const RunDefinition& run;
  const RunSettings& settings;
  const Progress& progress;
};

// Throws CaseFileError (file:line) unless the scheme is one of sph/'s.
void require_scheme(const SphRun& sph, const RunDefinition& run);

RunResult run_sph(const SphRun& sph, const RunRequest& request);
RunResult run_interfoam(const InterFoamRun& interfoam, const RunRequest& request);
RunResult run_linear(const LinearRun& linear, const RunRequest& request);

}  // namespace slosh

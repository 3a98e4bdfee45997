// The time step of an SPH run before it runs.
#pragma once

#include <optional>

#include "verification/case/case_definition.hpp"

namespace slosh {

// The length of an SPH run's steps before it runs: the scheme's stable step of liquid at rest, and
// the equal steps from one sample to the next that sph/run.cpp makes of it. Violent flow
// shortens them further.
struct SphStep {
  double stable;           // [s]
  double between_samples;  // [s], the sample interval over a whole number

  // Returns the share of the stable step that landing on the samples costs, from 0 to 1.
  double lost_to_samples() const { return 1 - between_samples / stable; }
};

// Returns nullopt for a run of another solver, or one that SPH does not take (require_runnable,
// run_case.hpp). `measured_speed` is what the run's coarse run has measured [m/s]; without it the
// step is that of the estimated largest speed.
std::optional<SphStep> sph_step(const CaseDefinition& definition, const RunDefinition& run,
                                std::optional<double> measured_speed = {});

}  // namespace slosh

// How long the steps of an SPH run are before it runs: the scheme's stable step of liquid at rest,
// and what is left of it where the steps land on the samples, as sph/run_scheme.hpp has it: equal
// steps from one sample to the next. Violent flow shortens them further.
#pragma once

#include <optional>

#include "verification/case/case_definition.hpp"

namespace slosh {

struct SphStep {
  double stable;           // [s]
  double between_samples;  // [s], the sample interval over a whole number

  // The share of the stable step that landing on the samples costs, from 0 to 1.
  double lost_to_samples() const { return 1 - between_samples / stable; }
};

// Of an SPH run that the solver takes (require_runnable, run_case.hpp); nothing of another run.
std::optional<SphStep> sph_step(const CaseDefinition& definition, const RunDefinition& run);

}  // namespace slosh

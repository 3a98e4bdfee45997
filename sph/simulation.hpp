// One SPH run of a rectangular tank that surges and rolls, by a scheme that is chosen by name.
#pragma once

#include <string>
#include <vector>

#include "sph/run_output.hpp"
#include "sph/scene.hpp"

namespace slosh::sph {

std::vector<std::string> scheme_names();

// Returns the names of the variants of the scheme `recommended`; each changes one thing.
std::vector<std::string> variant_names();

// Returns the scheme's largest stable time step for liquid at rest [s]. The steps of a run are
// shorter where the flow is violent, and where they have to end on a sample time. Throws as `run`
// does for a scheme, a variant or its numbers.
double stable_time_step(const std::string& scheme, const Scene& scene);

// Throws std::invalid_argument for an unknown scheme or variant, or for a scene that the scheme
// cannot solve, and SimulationError where the run fails.
RunOutput run(const std::string& scheme, const Scene& scene, const Progress& progress);

}  // namespace slosh::sph

// The run of one scheme: the main loop.
#pragma once

#include "sph/liquid.hpp"
#include "sph/run_output.hpp"
#include "sph/scene.hpp"
#include "sph/scheme.hpp"

namespace slosh::sph {

RunOutput run(const Method& method, const Scene& scene, const Progress& progress);

// Returns the longest stable step from a state whose accelerations are known [s].
double stable_step(const Liquid& liquid, double gravity);

}  // namespace slosh::sph

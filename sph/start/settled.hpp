// A liquid that has come to rest by itself. The square lattice changes to a closer packing by its
// own pressure, and the energy that this sets free is damped before the run.
#pragma once

#include "sph/scene.hpp"
#include "sph/scheme.hpp"

namespace slosh::sph {

// Returns `start` after a damped relaxation in a tank at rest. A small disorder, symmetric about
// the tank's middle, starts the rearrangement.
Particles settled(const Scene& scene, const Method& method, const Particles& start);

}  // namespace slosh::sph

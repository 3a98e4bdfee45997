// The liquid's initial state, one of:
//   lattice    the hydrostatic lattice with the initial velocity (initial_lattice.hpp)
//   settled    the same after a relaxation (settled.hpp)
//   projected  the lattice in the incompressible liquid's state at 0+ (projection.hpp)
#pragma once

#include "sph/scene.hpp"
#include "sph/scheme.hpp"

namespace slosh::sph {

const char* start_name(InitialState state);

// Returns the scene's initial state, or else the method's own.
InitialState chosen_state(const Scene& scene, const Method& method);

// Returns the lattice in the method's frame, before any preparation. Throws std::invalid_argument
// for an initial state that is impossible with the method or the scene.
Particles start_lattice(const Scene& scene, const Method& method);

// Returns the liquid in its initial state, with the same exceptions and those of the preparation.
Particles initial_state(const Scene& scene, const Method& method);

}  // namespace slosh::sph

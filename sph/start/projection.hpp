// The lattice in the incompressible liquid's state at 0+. A weakly compressible liquid rings with
// sound waves after an impulsive start or the release of a dam, and this state spares it that. G is
// the scheme's own pressure acceleration and D its divergence, walls included:
//   velocity  v = u + G P, D v = 0 with the walls' velocity, where P is the pressure impulse of the
//             start (Batchelor 1967, section 6.10)
//   pressure  D (G p + g) = 0 with the walls' acceleration, where g includes the inertial forces of
//             the tank's frame
// This is the projection of Cummins & Rudman 1999, eqs 11 to 15.
#pragma once

#include "sph/scene.hpp"
#include "sph/scheme.hpp"

namespace slosh::sph {

// Returns the particles of the lattice `start` in that state; their order may differ from the
// lattice's. The method must have operators for pressure alone (scheme_terms.hpp). Throws
// SimulationError where the linear solver does not converge.
Particles projected(const Scene& scene, const Method& method, const Particles& start);

}  // namespace slosh::sph

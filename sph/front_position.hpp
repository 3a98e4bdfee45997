// The front of a liquid that runs along the tank's bottom:
//   x at which the lowest two layers of particles first have a gap wider than two spacings,
// counted from the left wall, with half a spacing for the last particle's own extent. Such a gap
// leaves less than half a spacing's depth of liquid, as interFoam's front is where its lowest cells
// are less than half full. Single particles that run ahead and drops that fall there are not the
// front; an obstacle on the bottom ends it. Of two layers, because one alone has gaps under liquid:
// where a bottom without slip holds its particles back, or lets them lift off by a spacing.
#pragma once

#include "sph/neighbours/particles.hpp"

namespace slosh::sph {

// [m] from the left wall, which is at `wall_left` in the particles' frame; 0 where no particle of
// the layers is near it.
double front_position(const Particles& particles, double particle_spacing);

}  // namespace slosh::sph

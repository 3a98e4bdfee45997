// The force of the liquid on each wall of the tank: the reaction to the momentum sum over the
// images or the particles that lie behind it, and to its repulsive particles. What lies behind two
// walls, beyond a corner, acts normal to each: its x component counts for the side wall and its z
// component for the bottom or the roof. So does what lies behind an inclined side of an outline.
// The forces of the four walls thus add up to that on the tank, less those of obstacles within the
// tank and the friction of the gap walls.
#pragma once

#include <array>

#include "sph/liquid.hpp"

namespace slosh::sph {

using WallForces = std::array<Vector2, 4>;  // [N/m], along the tank's axes, in the order of Wall

// The sources must be those of the momentum sum at the liquid's time
// (Liquid::accelerate_for_sample). The outline is nullptr in a rectangle.
WallForces wall_forces(Liquid& liquid, const TankOutline* outline, double gravity);

}  // namespace slosh::sph

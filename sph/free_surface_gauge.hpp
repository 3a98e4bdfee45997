// The free surface's elevation above the still level to a small fraction of a particle: the depth
// of liquid in a column, as the integral of the particles' volumes over a smooth window across x,
//   eta(x) = sum_b V_b M((x - x_b) / w_b) / w_b - fill_depth,   w_b = 3 lattice spacings,
// M the interpolating cubic M4' (Monaghan 1985, eq. 3.9), which sums to one over a lattice and has
// no second moment: a wave of wave number k is changed only by the order of (k w)^4. The window is
// wide against the lattice, because a scheme may pack particles tighter in one place (along a wall)
// than in another while their densities do not tell. Liquid beyond a side wall is the mirror image
// of that before it. What it measures is the depth of liquid, drops and overturning jets included,
// as a column integral of VOF does.
#pragma once

#include "sph/neighbours/particles.hpp"

namespace slosh::sph {

// x from the left wall [m]; `wall_left` is the wall's place in the particles' frame. Result in m.
double surface_elevation(const Particles& particles, double tank_length, double fill_depth,
                         double x);

// How far above the still level [m] the liquid reaches near x, spray included: the upper edge, half
// a spacing above its centre, of the highest particle within a spacing of x; minus the fill depth
// where there is none.
double highest_surface(const Particles& particles, double fill_depth, double x);

}  // namespace slosh::sph

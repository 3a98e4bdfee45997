// The free surface's elevation above the still level to a small fraction of a particle: the depth
// of liquid in a column, as the integral of the particles' volumes over a smooth window across x,
//   eta(x) = sum_b V_b M((x - x_b) / s_b) / s_b - fill_depth,
// M the cubic B-spline with knots one lattice spacing s_b apart, which sums to one over a lattice:
// each row of particles counts with its own thickness, wherever its particles stand. The window
// smooths a wave of wave number k by (k s)^2 / 6. Liquid beyond a side wall is the mirror image of
// that before it. What it measures is the depth of liquid, drops and overturning jets included, as
// a column integral of VOF does.
#pragma once

#include "sph/particles.hpp"

namespace slosh::sph {

// x from the left wall [m]; `wall_left` is the wall's place in the particles' frame. Result in m.
double surface_elevation(const Particles& particles, double wall_left, double tank_length,
                         double fill_depth, double x);

}  // namespace slosh::sph

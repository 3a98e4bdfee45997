// The position of the free surface: its elevation, its highest point and the front on the bottom.
#pragma once

#include "sph/neighbours/particles.hpp"
#include "sph/walls/line_of_sight.hpp"

namespace slosh::sph {

// The width of the window over the lattice's spacing.
inline constexpr double window_width = 3;

// Returns M(s), which has the support 2, the integral 1 and no second moment.
double window(double s);
// Returns the integral of M from minus infinity to s.
double window_integral(double s);

// Returns the surface's elevation above the still level [m] at x from the left wall [m], resolved
// to a small fraction of a particle. It is the depth of liquid in a column, the integral of the
// particles' volumes over a smooth window along x:
//   eta(x) = sum_b V_b M((x - x_b) / w_b) / w_b - fill_depth,   w_b = 3 lattice spacings
// M is the interpolating cubic M4' (Monaghan 1985, eq. 3.9). It sums to one over a lattice and has
// no second moment, so that a wave of wave number k is changed only at the order (k w)^4. The
// window is wide because a scheme may pack particles more tightly in one place (along a wall) than
// in another without a trace in their densities. Beyond a side wall the liquid is continued by its
// mirror image. Drops and overturning jets are included, as in a column integral of VOF.
double surface_elevation(const Particles& particles, double tank_length, double fill_depth,
                         double x);

// As above, in a tank with obstacles thinner than the window (sight_of_instruments). At the height
// of such an obstacle the window ends at its face, and the liquid before it is continued by its
// mirror image. Over the thickness of the obstacle itself it counts for nothing.
double surface_elevation(const Particles& particles, double tank_length, double fill_depth,
                         double x, const LineOfSight& sight);

// Returns the height above the still level [m] that the liquid reaches near x, spray included: the
// upper edge, half a spacing above its centre, of the highest particle within a spacing of x.
// Returns minus the fill depth where there is no such particle.
double highest_surface(const Particles& particles, double fill_depth, double x);

// Returns the front [m from the left wall] of a liquid that runs along the tank's bottom: the x at
// which the lowest two layers of particles first have a gap wider than two spacings, plus half a
// spacing for the last particle's own extent; 0 where no particle of these layers is near the wall.
// Such a gap leaves less than half a spacing's depth of liquid, as interFoam's front is where its
// lowest cells are less than half full. Single particles that run ahead and drops do not count as
// the front; an obstacle on the bottom ends it. Two layers are needed because one alone has gaps
// under liquid, where a no-slip bottom holds its particles back or lets them lift off by a spacing.
double front_position(const Particles& particles, double particle_spacing);

}  // namespace slosh::sph

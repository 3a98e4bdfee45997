// Checks of the state during a run. A bad particle stops the run with an error that names the
// particle's state, the time and the cause.
#pragma once

#include <cstddef>

#include "sph/neighbours/particles.hpp"

namespace slosh::sph {

// Checks all particles after each step, in one pass over the memory. Throws SimulationError when a
// particle's state is not finite, or when its density is above twice the rest density or below a
// fifth of it. At a Mach number of 0.1 the density of a weakly compressible liquid varies by 1 % at
// most. A particle of the spray that hits a wall or another particle at the speed v is compressed
// by v / c0, that is by half of its density at half the speed of sound; a third was measured where
// a jet meets the roof's corner at 5 m/s. A particle that leaves the surface loses its neighbours'
// part of sum_b m_b W_ab, whose time derivative is the continuity equation: up to about 60 %
// without density diffusion.
void check_state(const Particles& particles, double rest_density, double time);

// Checks the next step. Throws SimulationError when the largest acceleration requires a step of
// less than a ten-thousandth of the longest one. By the force criterion 0.25 sqrt(h / |a|)
// (terms/time_step.hpp) and at a Courant number of 0.8, that particle would gain eight million
// times the speed of sound in a step of the longest length.
void check_step(double step, double longest_step, const Particles& particles, const Rates& rates,
                double time);

// Throws SimulationError with the message that particle `index` is `cause`.
[[noreturn]] void throw_bad_particle(const Particles& particles, std::size_t index, double time,
                                     const char* cause);

}  // namespace slosh::sph

// The state is checked while it runs: the first bad particle stops the run with its state, the time
// and the cause.
#pragma once

#include <cstddef>

#include "sph/neighbours/particles.hpp"

namespace slosh::sph {

// After each step, in one pass over the memory. Throws SimulationError when a particle's state is
// not finite or its density has risen above twice
// the rest density or has fallen below a fifth of it. A weakly compressible liquid at a Mach number
// of 0.1 stays within 1 %, but a particle of the spray that strikes a wall or another at the speed
// v is compressed by v / c0, half of its density at half the speed of sound (measured: a third,
// where a jet meets the roof's corner at 5 m/s). A particle that leaves the
// surface loses what its neighbours gave to sum_b m_b W_ab, of which the continuity equation is the
// time derivative: up to some 60 %, where nothing diffuses the density.
void check_state(const Particles& particles, double rest_density, double time);

// Before each step. Throws SimulationError when the particle of the largest acceleration asks for a
// step of less than a ten-thousandth of the longest: at the force criterion's 0.25 sqrt(h / |a|)
// (terms/time_step.hpp) and a Courant number of 0.8 it would gain the speed of sound a thousand
// times over in a step of the usual length.
void check_step(double step, double longest_step, const Particles& particles, const Rates& rates,
                double time);

[[noreturn]] void throw_bad_particle(const Particles& particles, std::size_t index, double time,
                                     const char* cause);

}  // namespace slosh::sph

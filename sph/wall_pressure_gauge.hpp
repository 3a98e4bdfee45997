// The liquid's pressure on a sensor in a wall, from the particles in front of it. At places along
// the sensor at most a particle spacing apart, the pressure of the particles within three spacings,
// carried to the place by the gradient that the wall gives it, in the kernel's mean:
//   p = sum_b V_b W_b (p_b + rho_b g_w . (r - r_b)) / sum_b V_b W_b,
// W the Wendland C2 kernel and g_w gravity less the wall's acceleration there, exact for a liquid
// that rests against a wall in any motion (normal to the wall the gradient is rho g_w wherever the
// wall holds the liquid). The sensor shows the mean over its places. Where particles fill less than
// a fifth of the half disc in front of a place, it counts as dry: pressure 0, that of the gas.
#pragma once

#include <functional>

#include "sph/neighbours/particles.hpp"
#include "sph/simulation.hpp"
#include "sph/walls/frames.hpp"

namespace slosh::sph {

// [Pa]. `particles` as seen from the tank; `motion`, the tank's (frames.hpp); `pressure_at`, the
// equation of state: pressure [Pa] at a density [kg/m3].
template <class Motion>
double wall_pressure(const Particles& particles, const PressureGauge& gauge, const Scene& scene,
                     const Motion& motion, const std::function<double(double)>& pressure_at);

// Throws std::invalid_argument where the sensor is not wholly on its wall.
void require_on_wall(const PressureGauge& gauge, const Scene& scene);

}  // namespace slosh::sph

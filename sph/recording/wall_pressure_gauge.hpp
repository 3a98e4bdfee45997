// The liquid's pressure on a sensor in a wall. At points along the sensor, at most a particle
// spacing apart, it is the kernel-weighted mean over the particles within three spacings,
//   p = sum_b V_b W_b (p_b + rho_b g_w . (r - r_b)) / sum_b V_b W_b,
// where W is the Wendland C2 kernel and g_w is gravity less the wall's acceleration at the point.
// The gradient rho g_w extrapolates each particle's pressure to the point. This is exact for a
// liquid at rest relative to a wall in any motion. The sensor's value is the mean over its points.
// A point counts as dry, with the gas's pressure 0, where particles fill less than a fifth of the
// half disc in front of it.
#pragma once

#include <functional>

#include "sph/neighbours/particles.hpp"
#include "sph/scene.hpp"
#include "sph/walls/frames.hpp"

namespace slosh::sph {

// Returns the sensor's pressure [Pa]. `particles` are seen from the tank (recorder.hpp),
// `motion` is the tank's (walls/frames.hpp), and `pressure_at` is the equation of state, pressure
// [Pa] at a density [kg/m3].
double wall_pressure(const Particles& particles, const PressureGauge& gauge, const Scene& scene,
                     const TankMotion& motion, const std::function<double(double)>& pressure_at);

// Throws std::invalid_argument where the sensor is not wholly on its wall.
void require_on_wall(const PressureGauge& gauge, const Scene& scene);

}  // namespace slosh::sph

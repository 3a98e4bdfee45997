// The liquid's velocity and pressure at a place in the tank, from the particles within three
// spacings of it.
//   velocity  the value at the place of the linear function that fits the particles' velocities
//             relative to the tank best, each weighted by V_b W_b; exact for a linear velocity on
//             any set of particles, also beside a wall and at the surface
//   pressure  as of a sensor in a wall (wall_pressure_gauge.hpp), by the same formula
// W is the Wendland C2 kernel. The place counts as dry, and both are zero, where the particles and
// their mirror images in the tank's walls fill less than half of the kernel: the surface is then
// below the place.
#pragma once

#include <functional>

#include "sph/neighbours/particles.hpp"
#include "sph/scene.hpp"
#include "sph/walls/frames.hpp"

namespace slosh::sph {

struct Probed {
  Vector2 velocity;  // relative to the tank, along its axes [m/s]
  double pressure;   // [Pa]
};

// `particles` are seen from the tank (recorder.hpp), `motion` is the tank's, and
// `pressure_at` is the equation of state, pressure [Pa] at a density [kg/m3].
Probed probed(const Particles& particles, const Probe& probe, const Scene& scene,
              const TankMotion& motion, const std::function<double(double)>& pressure_at);

// Throws std::invalid_argument for a probe outside the tank.
void require_in_tank(const Probe& probe, const Scene& scene);

}  // namespace slosh::sph

// The walls' forces on the particles and their power.
#pragma once

#include "sph/neighbours/particles.hpp"
#include "sph/walls/frames.hpp"

namespace slosh::sph {

// Returns the acceleration of a particle by the other particles and the walls, that is without
// gravity and inertial forces, along the frame's axes [m/s2].
inline Vector2 push_on(const Particles& p, std::size_t i, const Rates& rates, const Tank& tank,
                       double gravity) {
  const Vector2 pulled = tank.pull(gravity, p.x[i], p.z[i], p.velocity_x[i], p.velocity_z[i]);
  return {rates.acceleration_x[i] - pulled.x, rates.acceleration_z[i] - pulled.z};
}

struct PowerAt {
  double time, power;  // [s], [W/m]
};

// Returns the walls' power on the liquid in the frame of the earth [W/m]: their force times the
// velocity of the roll's axis plus their moment about it times the roll rate. This equals the sum
// over the particles of the push times the velocity of the tank's point at the particle, because
// the forces between particles have no resultant force or moment. `tank` and `motion` are those at
// the time of the rates.
inline double power_of_walls(const Particles& p, const Rates& rates, const Tank& tank,
                             const TankMotion& motion, double gravity) {
  double power = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Vector2 place = tank.in_tank(p.x[i], p.z[i]), of_tank = motion.velocity(place.x, place.z),
                  velocity = tank.along_frame(of_tank.x, of_tank.z),
                  push = push_on(p, i, rates, tank, gravity);
    power += p.mass[i] * (push.x * velocity.x + push.z * velocity.z);
  }
  return power;
}

}  // namespace slosh::sph

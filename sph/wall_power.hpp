// What the tank's walls push the particles with, and the work of that.
#pragma once

#include "sph/neighbours/particles.hpp"
#include "sph/walls/frames.hpp"

namespace slosh::sph {

// What the other particles and the walls add to a particle's acceleration: all but gravity and the
// frame's own forces, along the frame's axes [m/s2].
template <class Tank>
Vector2 push_on(const Particles& p, std::size_t i, const Rates& rates, const Tank& tank,
                double gravity) {
  Vector2 pulled{0, 0};
  tank.pull(gravity, p.x[i], p.z[i], p.velocity_x[i], p.velocity_z[i], pulled.x, pulled.z);
  return {rates.acceleration_x[i] - pulled.x, rates.acceleration_z[i] - pulled.z};
}

struct PowerAt {
  double time, power;  // [s], [W/m]
};

// The walls' power on the liquid in the frame of the earth [W/m]: their force times the velocity of
// the roll's axis and their moment about it times the rate, which is the sum of every particle's
// push times the velocity of the tank's point that it is at. What the particles give one another
// has neither a force nor a moment. `tank` and `motion` of the moment of the rates.
template <class Tank, class Motion>
double power_of_walls(const Particles& p, const Rates& rates, const Tank& tank,
                      const Motion& motion, double gravity) {
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

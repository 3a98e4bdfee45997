// The liquid as seen by instruments that are fixed to the tank, in any frame of the scheme.
#pragma once

#include "sph/liquid.hpp"
#include "sph/walls/frames.hpp"
#include "sph/walls/wall_power.hpp"

namespace slosh::sph {

struct SeenFromTank {
  // Positions in the tank, and velocities relative to the earth along the tank's axes.
  Particles particles;
  // The acceleration of each particle by the other particles and the walls, that is without gravity
  // and inertial forces, along the tank's axes [m/s2].
  Array<double> push_x, push_z;

  template <class Visit>
  void for_each_named_field(const Visit& visit) {
    particles.for_each_named_field(visit);
    visit("push_x", push_x);
    visit("push_z", push_z);
  }
};

// Fills in `seen`; `motion` is the tank's at the liquid's time.
template <class Scheme>
void see_from_tank(const Liquid<Scheme>& liquid, const Motion<Scheme>& motion, SeenFromTank& seen) {
  const Particles& p = liquid.particles;
  const auto tank = liquid.tank_at(liquid.time);
  const double gravity = liquid.scheme().setting.gravity;
  Particles& view = seen.particles;
  view.density = p.density;
  view.mass = p.mass;
  view.spacing = p.spacing;
  view.lattice_spacing = p.lattice_spacing;
  for (auto* field :
       {&view.x, &view.z, &view.velocity_x, &view.velocity_z, &seen.push_x, &seen.push_z})
    field->resize(p.size());
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Vector2 place = tank.in_tank(p.x[i], p.z[i]);
    const Vector2 wall = tank.wall_velocity(p.x[i], p.z[i]),
                  of_tank = motion.velocity(place.x, place.z);
    const Vector2 relative = tank.along_tank(p.velocity_x[i] - wall.x, p.velocity_z[i] - wall.z);
    Vector2 push = push_on(p, i, liquid.rates, tank, gravity);
    push = tank.along_tank(push.x, push.z);
    view.x[i] = place.x;
    view.z[i] = place.z;
    view.velocity_x[i] = of_tank.x + relative.x;
    view.velocity_z[i] = of_tank.z + relative.z;
    seen.push_x[i] = push.x;
    seen.push_z[i] = push.z;
  }
}

}  // namespace slosh::sph

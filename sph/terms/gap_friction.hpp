// Friction of a narrow tank's front and back wall, which a solver in two dimensions does not see.
// The velocity v of a particle is the mean over the gap between the walls, and their stress slows
// it down to their own velocity:
//   dv_a/dt = ... - r (v_a - v_wall)
// The rate r [1/s] is the scene's. For laminar flow that oscillates between the walls it follows
// from the liquid's viscosity, the gap and the frequency (Landau & Lifshitz 1987, section 24,
// problem 6).
//
// The step is explicit in the friction, and r dt is at most largest_friction_per_step
// (terms/time_step.hpp). A velocity is multiplied by 1 - r dt in a step instead of exp(-r dt). This
// is stable up to r dt = 2, keeps the velocity's sign up to 1, and decays 5 % too fast at 0.1.
#pragma once

#include "sph/neighbours/particles.hpp"
#include "sph/walls/tank_walls.hpp"

namespace slosh::sph {

// Adds the friction to the accelerations. `tank` is at the time of the velocities.
template <class Tank>
void add_gap_friction(double rate, const Particles& p, const Tank& tank, Rates& rates) {
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Vector2 wall = tank.wall_velocity(p.x[i], p.z[i]);
    rates.acceleration_x[i] -= rate * (p.velocity_x[i] - wall.x);
    rates.acceleration_z[i] -= rate * (p.velocity_z[i] - wall.z);
  }
}

}  // namespace slosh::sph

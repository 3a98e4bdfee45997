// The friction of a narrow tank's front and back wall, which a solver in two dimensions does not
// see. The velocity v of a particle is the mean over the gap between the walls, relative to them:
//   dv/dt = ... - steady_friction v - sum_n friction_n (v - m_n)
// Each particle carries the velocities m_n of its boundary layers (gap_layers.hpp), in components
// along the tank's axes. At the start they are zero: the liquid has not moved yet.
//
// The step is explicit in the friction, and the largest friction times the step is at most
// largest_friction_per_step (terms/time_step.hpp). The layers' velocities follow exactly for a
// velocity that is constant in the step.
#pragma once

#include <cmath>

#include "sph/neighbours/particles.hpp"
#include "sph/terms/gap_layers.hpp"
#include "sph/walls/tank_walls.hpp"

namespace slosh::sph {

class GapFriction {
 public:
  explicit GapFriction(const Setting& setting) : gap_(gap_layers(setting)) {}

  bool exists() const { return gap_.steady_friction > 0; }

  // Gives the particles the velocities of their layers at the start.
  void begin(Particles& p) const {
    p.layer_velocity.assign(2 * gap_.layers.size(), Array<double>(p.size(), 0.0));
  }

  // Adds `share` of the friction to the accelerations. `tank` is at the time of the velocities.
  template <class Tank>
  void add(double share, const Particles& p, const Tank& tank, Rates& rates) const {
#pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < p.size(); ++i) {
      const Vector2 v = relative_velocity(p, tank, i);
      Vector2 force{gap_.steady_friction * v.x, gap_.steady_friction * v.z};
      for (std::size_t n = 0; n < gap_.layers.size(); ++n) {
        const double friction = gap_.layers[n].friction;
        force.x += friction * (v.x - p.layer_velocity[2 * n][i]);
        force.z += friction * (v.z - p.layer_velocity[2 * n + 1][i]);
      }
      const Vector2 seen = tank.along_frame(share * force.x, share * force.z);
      rates.acceleration_x[i] -= seen.x;
      rates.acceleration_z[i] -= seen.z;
    }
  }

  // Lets the layers' velocities follow those of the particles for the time dt.
  template <class Tank>
  void advance(Particles& p, const Tank& tank, double dt) const {
    Array<double> approach(gap_.layers.size());
    for (std::size_t n = 0; n < approach.size(); ++n)
      approach[n] = -std::expm1(-gap_.layers[n].rate * dt);
#pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < p.size(); ++i) {
      const Vector2 v = relative_velocity(p, tank, i);
      for (std::size_t n = 0; n < approach.size(); ++n) {
        double &x = p.layer_velocity[2 * n][i], &z = p.layer_velocity[2 * n + 1][i];
        x += approach[n] * (v.x - x);
        z += approach[n] * (v.z - z);
      }
    }
  }

 private:
  template <class Tank>
  static Vector2 relative_velocity(const Particles& p, const Tank& tank, std::size_t i) {
    const Vector2 wall = tank.wall_velocity(p.x[i], p.z[i]);
    return tank.along_tank(p.velocity_x[i] - wall.x, p.velocity_z[i] - wall.z);
  }

  GapLayers gap_;
};

}  // namespace slosh::sph

// The friction of a narrow tank's gap walls, which a solver in two dimensions does not
// see. The velocity v of a particle is the mean over the gap between the walls, relative to them:
//   dv/dt = ... - steady_friction v - sum_n friction_n (v - m_n)
// Each particle carries the velocities m_n of its boundary layers (gap_layers.hpp), in components
// along the tank's axes. At the start they are zero: the liquid has not moved yet.
//
// The step is explicit in the friction, and the largest friction times the step is at most
// largest_friction_per_step (terms/time_step.hpp). The layers' velocities follow exactly for a
// velocity that is constant in the step.
#pragma once

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
  void add(double share, const Particles& p, const Tank& tank, Rates& rates) const;

  // Lets the layers' velocities follow those of the particles for the time dt.
  void advance(Particles& p, const Tank& tank, double dt) const;

 private:
  GapLayers gap_;
};

}  // namespace slosh::sph

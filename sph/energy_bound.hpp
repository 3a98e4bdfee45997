// What the liquid's mechanical energy cannot exceed, whatever the flow, from what is recorded at
// the sample times anyway: a run that passes this has gained energy from nowhere. It catches a time
// step beyond the limit of stability where the particles' noise saturates before any leaves its
// density range. The bound is wide, since the walls' power is taken at samples only:
//   kinetic + potential - their start
//       <= 2 integral of |power of the walls| dt + 2 M V^2 + rho g h^2 L / 200
// with the liquid's mass M and the tank's largest speed V so far over it, for starts and stops
// within a sample, and a hundredth of the potential energy of a basin of the still depth for what
// the start's lattice and its compression set free. In 160 runs of calm and violent tanks the left
// side was at most 0.56 of the right one.
#pragma once

#include "sph/neighbours/particles.hpp"
#include "sph/simulation.hpp"

namespace slosh::sph {

class EnergyBound {
 public:
  EnergyBound(const Scene& scene, const Particles& liquid);

  // `gained`: kinetic and potential energy less those of the start [J/m]; `wall_power` [W/m];
  // `tank_speed`: the largest of a point of the tank that the liquid can touch [m/s]. Throws
  // SimulationError beyond the bound, with the fastest particle.
  void check(double time, double gained, double wall_power, double tank_speed,
             const Particles& liquid);

  // What is kept from sample to sample: visit(name, value).
  template <class Visit>
  void for_each_number(const Visit& visit) {
    visit("bound_work", work_);
    visit("bound_power", last_power_);
    visit("bound_time", last_time_);
    visit("bound_tank_speed", tank_speed_);
  }

 private:
  double mass_, slack_;
  double work_ = 0, last_power_ = 0, last_time_ = 0, tank_speed_ = 0;
};

}  // namespace slosh::sph

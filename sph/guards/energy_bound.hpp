// An upper bound of the liquid's mechanical energy in any flow, from quantities that are recorded
// at the sample times. A run that exceeds it has gained energy without a source. This detects a
// time step beyond the stability limit whose noise saturates before any particle leaves its density
// range. The bound is wide because the walls' power is known at the samples only:
//   kinetic + potential - their initial values
//       <= 2 integral of |power of the walls| dt + 2 M V^2 + rho g h^2 L / 200
// M is the liquid's mass and V the tank's largest speed so far; the term 2 M V^2 covers starts and
// stops within a sample. The last term, a hundredth of the potential energy of a basin of the still
// depth, covers the energy that the initial lattice and its compression set free. In 160 runs of
// calm and violent tanks the left side was at most 0.56 of the right one.
#pragma once

#include "sph/neighbours/particles.hpp"
#include "sph/scene.hpp"

namespace slosh::sph {

class EnergyBound {
 public:
  EnergyBound(const Scene& scene, const Particles& liquid);

  // Throws SimulationError with the fastest particle where the bound is exceeded.
  //   gained      kinetic and potential energy less their initial values [J/m]
  //   wall_power  power of the walls on the liquid [W/m]
  //   tank_speed  largest speed of a point of the tank that the liquid can touch [m/s]
  void check(double time, double gained, double wall_power, double tank_speed,
             const Particles& liquid);

  // Calls visit(name, value) for every number that is kept from sample to sample.
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

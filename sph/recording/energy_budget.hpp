// The balance of the liquid's energy in the frame of the earth [J/m]:
//   kinetic + potential + internal = initial values + wall work - dissipated energy + residual
// The powers are, with the tank's velocity V at a particle,
//   walls       sum_a m_a push_a . V_a                                      (walls/wall_power.hpp)
//   dissipated  -sum_a m_a (v_a - V_a) . (dv_a/dt)_viscous
//               -sum_a m_a p_a / rho_a^2 (drho_a/dt)_diffusive
// The viscous and the diffusive part of the rates are the differences to the rates without
// viscosity and diffusion. The dissipation takes velocities relative to the tank, because the
// friction at the walls is a part of the walls' work. The remaining powers without gravity,
//   sum m (v - V) . dv/dt + sum m p / rho^2 drho/dt,
// cancel pair by pair in the liquid, since the two sums of a formulation are adjoint
// (terms/formulation.hpp). The power on dynamic boundary particles is their own compression, which
// counts as internal energy.
//
// The residual consists of
//   the power of images and ghost particles that is not due to the walls' motion
//   the energy of particles that are put back at walls, and a repulsive wall's potential
//   time errors: a staggered velocity's half step, and the dissipation between samples
// Only the viscous part of the dissipation has a definite sign: a diffusion that does not act on
// the hydrostatic density can give energy back.
#pragma once

#include <vector>

#include "sph/liquid.hpp"
#include "sph/run_output.hpp"

namespace slosh::sph {

class EnergyBudget {
 public:
  explicit EnergyBudget(Liquid& liquid) { liquid.keep_wall_power(); }

  void add_step(const Liquid& liquid) { wall_work_.add(liquid.wall_power()); }

  // Appends internal_energy, wall_work, dissipated_energy and energy_residual at the liquid's time.
  // `mechanical` is the kinetic and potential energy [J/m].
  void record(Liquid& liquid, double mechanical, std::vector<RecordedSeries>& series);

  template <class Visit>
  void for_each_named_field(const Visit& visit) {
    real_rates_.for_each_named_field(visit);
    ideal_rates_.for_each_named_field(visit);
  }

  // Calls visit(name, value) for every number that is kept from sample to sample.
  template <class Visit>
  void for_each_number(const Visit& visit) {
    visit("start_energy", start_);
    visit("wall_work", wall_work_.sum);
    visit("wall_power", wall_work_.last.power);
    visit("wall_power_time", wall_work_.last.time);
    visit("dissipated_energy", dissipated_.sum);
    visit("dissipated_power", dissipated_.last.power);
    visit("dissipated_power_time", dissipated_.last.time);
  }

 private:
  // The integral of a power over time, by the trapezoidal rule.
  struct Integral {
    double sum = 0;
    PowerAt last = {};

    void add(const PowerAt& now) {
      sum += 0.5 * (now.time - last.time) * (last.power + now.power);
      last = now;
    }
  };

  double power_dissipated(const Liquid& liquid) const;

  Rates real_rates_, ideal_rates_;  // with and without viscosity and density diffusion
  double start_ = 0;
  Integral wall_work_, dissipated_;
};

}  // namespace slosh::sph

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
#include "sph/setting.hpp"

namespace slosh::sph {

template <class Scheme>
class EnergyBudget {
 public:
  explicit EnergyBudget(Liquid<Scheme>& liquid) : ideal_(liquid.scheme()) {
    ideal_.formulation.viscous_share = 0;
    if constexpr (Scheme::DensityDiffusion::active) ideal_.density_diffusion.switch_off();
    liquid.keep_wall_power();
  }

  void add_step(const Liquid<Scheme>& liquid) { wall_work_.add(liquid.wall_power()); }

  // Appends internal_energy, wall_work, dissipated_energy and energy_residual at the liquid's time.
  // `mechanical` is the kinetic and potential energy [J/m].
  void record(Liquid<Scheme>& liquid, double mechanical, std::vector<RecordedSeries>& series) {
    liquid.evaluate(liquid.scheme(), real_rates_);
    liquid.evaluate(ideal_, ideal_rates_);
    const PowerAt wall_power = liquid.power_of_walls(real_rates_, liquid.time),
                  dissipated_power{liquid.time, power_dissipated(liquid)};
    const double internal = internal_energy(liquid);
    if (series.empty()) {
      wall_work_.last = wall_power;
      dissipated_.last = dissipated_power;
      start_ = mechanical + internal;
      for (const char* name :
           {"internal_energy", "wall_work", "dissipated_energy", "energy_residual"})
        series.push_back({name, "J/m", {}});
    }
    wall_work_.add(wall_power);
    dissipated_.add(dissipated_power);
    const double values[]{internal, wall_work_.sum, dissipated_.sum,
                          mechanical + internal - start_ - wall_work_.sum + dissipated_.sum};
    for (std::size_t i = 0; i < series.size(); ++i) {
      series[i].history.time.push_back(liquid.time);
      series[i].history.value.push_back(values[i]);
    }
  }

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

  static double internal_energy(const Liquid<Scheme>& liquid) {
    const Particles& p = liquid.particles;
    const auto& state = liquid.scheme().state;
    double sum = 0;
    for (std::size_t i = 0; i < p.size(); ++i) sum += p.mass[i] * state.energy(p.density[i]);
    if constexpr (Scheme::Solids::has_density) {
      const Setting& s = liquid.scheme().setting;
      const double mass = s.rest_density * s.particle_spacing * s.particle_spacing;
      for (const double density : liquid.solids().density()) sum += mass * state.energy(density);
    }
    return sum;
  }

  // Returns the dissipated power [W/m] from the rates with and without viscosity and diffusion.
  double power_dissipated(const Liquid<Scheme>& liquid) const {
    const Particles& p = liquid.particles;
    const auto tank = liquid.tank_at(liquid.time);
    const Rates &real = real_rates_, &ideal = ideal_rates_;
    double sum = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
      const double rho = p.density[i];
      const Vector2 wall = tank.wall_velocity(p.x[i], p.z[i]);
      const double viscous =
          (p.velocity_x[i] - wall.x) * (real.acceleration_x[i] - ideal.acceleration_x[i]) +
          (p.velocity_z[i] - wall.z) * (real.acceleration_z[i] - ideal.acceleration_z[i]);
      const double diffusive = liquid.scheme().state.pressure(rho) / (rho * rho) *
                               (real.density_rate[i] - ideal.density_rate[i]);
      sum -= p.mass[i] * (viscous + diffusive);
    }
    return sum;
  }

  Scheme ideal_;  // without viscosity and density diffusion
  Rates real_rates_, ideal_rates_;
  double start_ = 0;
  Integral wall_work_, dissipated_;
};

}  // namespace slosh::sph

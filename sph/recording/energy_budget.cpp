#include "sph/recording/energy_budget.hpp"

namespace slosh::sph {
namespace {

double internal_energy(const Liquid& liquid) {
  const Particles& p = liquid.particles;
  const SchemeTerms& terms = liquid.terms();
  double sum = 0;
  for (std::size_t i = 0; i < p.size(); ++i) sum += p.mass[i] * terms.energy(p.density[i]);
  if (const Array<double>* solids = liquid.solids().density()) {
    const Setting& s = liquid.setting();
    const double mass = s.rest_density * s.particle_spacing * s.particle_spacing;
    for (const double density : *solids) sum += mass * terms.energy(density);
  }
  return sum;
}

}  // namespace

void EnergyBudget::record(Liquid& liquid, double mechanical, std::vector<RecordedSeries>& series) {
  liquid.evaluate(real_rates_);
  liquid.evaluate(ideal_rates_, Dissipation::left_out);
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

// Returns the dissipated power [W/m] from the rates with and without viscosity and diffusion.
double EnergyBudget::power_dissipated(const Liquid& liquid) const {
  const Particles& p = liquid.particles;
  const Tank tank = liquid.tank_at(liquid.time);
  const Rates &real = real_rates_, &ideal = ideal_rates_;
  double sum = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double rho = p.density[i];
    const Vector2 wall = tank.wall_velocity(p.x[i], p.z[i]);
    const double viscous =
        (p.velocity_x[i] - wall.x) * (real.acceleration_x[i] - ideal.acceleration_x[i]) +
        (p.velocity_z[i] - wall.z) * (real.acceleration_z[i] - ideal.acceleration_z[i]);
    const double diffusive =
        liquid.terms().pressure(rho) / (rho * rho) * (real.density_rate[i] - ideal.density_rate[i]);
    sum -= p.mass[i] * (viscous + diffusive);
  }
  return sum;
}

}  // namespace slosh::sph

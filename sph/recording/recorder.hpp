// The recorder enters the requested quantities into the output at the sample times.
#pragma once

#include <optional>
#include <vector>

#include "sph/guards/energy_bound.hpp"
#include "sph/held_arrays.hpp"
#include "sph/liquid.hpp"
#include "sph/recording/column_in_outline.hpp"
#include "sph/recording/energy_budget.hpp"
#include "sph/recording/free_surface.hpp"
#include "sph/recording/near_particles.hpp"
#include "sph/recording/probe.hpp"
#include "sph/recording/seen_from_tank.hpp"
#include "sph/recording/soundness.hpp"
#include "sph/recording/still_water.hpp"
#include "sph/recording/wall_forces.hpp"
#include "sph/recording/wall_pressure_gauge.hpp"
#include "sph/run_output.hpp"
#include "sph/scene.hpp"
#include "sph/scheme.hpp"
#include "sph/walls/frames.hpp"
#include "sph/walls/tank_outline.hpp"

namespace slosh::sph {

template <class Scheme>
class Recorder {
 public:
  Recorder(const Scene& scene, Liquid<Scheme>& liquid)
      : scene_(scene), sight_(sight_of_instruments(scene)), energy_bound_(scene, liquid.particles) {
    if (const auto outline = outline_of(scene))
      for (const Gauge& gauge : scene.gauges)
        columns_.emplace_back(*outline, scene.fill_depth, gauge.x, scene.particle_spacing);
    for (const PressureGauge& gauge : scene.pressure_gauges) require_on_wall(gauge, scene);
    for (const Probe& probe : scene.probes) require_in_tank(probe, scene);
    if (scene.record_still_water)
      still_water_.emplace(
          scene, liquid.particles,
          [state = liquid.scheme().state](double density) { return state.pressure(density); });
    if (scene.record_energy_budget) energy_budget_.emplace(liquid);
  }

  // Records what is integrated over every step.
  void add_step(const Liquid<Scheme>& liquid) {
    if (energy_budget_) energy_budget_->add_step(liquid);
  }

  // Records the liquid, whose accelerations must be those of its present state and time. `is_last`:
  // this is the run's last sample.
  void record(Liquid<Scheme>& liquid, bool is_last) {
    const Motion<Scheme> motion(scene_, liquid.time);
    see_from_tank(liquid, motion, seen_);
    record_gauges(liquid, motion);
    record_probes(liquid, motion);
    record_wall_forces(liquid);
    if (still_water_) still_water_->record(seen_.particles, liquid.time, output.still_water);
    record_energies(liquid.time, motion);
    if (energy_budget_)
      energy_budget_->record(
          liquid, output.kinetic_energy.value.back() + output.potential_energy.value.back(),
          output.energy);
    record_forces(liquid.time);
    soundness_.record(liquid, is_last, output);
    check_energy(liquid.time, motion);
  }

  // Passes on a snapshot of the time that has just been recorded. The function is never inlined, so
  // that the test of absent terms sees its call whatever the compiler (sph/counts).
  [[gnu::noinline]] void record_snapshot(const Liquid<Scheme>& liquid) const {
    const Particles& p = seen_.particles;
    const auto values = [](const Array<double>& field) {
      return std::vector<double>(field.begin(), field.end());
    };
    Snapshot snapshot{liquid.time,          values(p.x), values(p.z),      values(p.velocity_x),
                      values(p.velocity_z), {},          values(p.density)};
    for (const double density : p.density)
      snapshot.pressure.push_back(liquid.scheme().state.pressure(density));
    scene_.record_snapshot(snapshot);
  }

  // Calls visit(name, value) for every number besides the output that is kept from sample to
  // sample.
  template <class Visit>
  void for_each_number(const Visit& visit) {
    visit("initial_potential_energy", initial_potential_);
    energy_bound_.for_each_number(visit);
    soundness_.for_each_number(visit);
    if (still_water_) still_water_->for_each_number(visit);
    if (energy_budget_) energy_budget_->for_each_number(visit);
  }

  void report_memory(HeldArrays& held) {
    held.add_all("record", seen_);
    if (energy_budget_) held.add_all("energy budget", *energy_budget_);
  }

  RunOutput output;

 private:
  static void push(History& history, double time, double value) {
    history.time.push_back(time);
    history.value.push_back(value);
  }
  void record_gauges(const Liquid<Scheme>& liquid, const Motion<Scheme>& motion) {
    const Particles& p = seen_.particles;
    const double t = liquid.time;
    for (std::size_t k = 0; k < scene_.gauges.size(); ++k) {
      const Gauge& gauge = scene_.gauges[k];
      push(output.elevation[gauge.name], t,
           !columns_.empty() ? columns_[k].elevation(p)
           : sight_.exists()
               ? surface_elevation(p, scene_.tank_length, scene_.fill_depth, gauge.x, sight_)
               : surface_elevation(p, scene_.tank_length, scene_.fill_depth, gauge.x));
      push(output.highest_surface[gauge.name], t, highest_surface(p, scene_.fill_depth, gauge.x));
    }
    for (const PressureGauge& gauge : scene_.pressure_gauges)
      push(output.wall_pressure[gauge.name], t,
           wall_pressure(p, gauge, scene_, motion,
                         [&](double density) { return liquid.scheme().state.pressure(density); }));
    if (scene_.column_width)
      push(output.front_position, t, front_position(p, scene_.particle_spacing));
  }

  void record_probes(const Liquid<Scheme>& liquid, const Motion<Scheme>& motion) {
    for (const Probe& probe : scene_.probes) {
      const Probed found = probed(seen_.particles, probe, scene_, motion, [&](double density) {
        return liquid.scheme().state.pressure(density);
      });
      push(output.velocity_x[probe.name], liquid.time, found.velocity.x);
      push(output.velocity_z[probe.name], liquid.time, found.velocity.z);
      push(output.pressure[probe.name], liquid.time, found.pressure);
    }
  }

  // Reads the sources of the momentum sum, which the next evaluation of any other sum overwrites.
  void record_wall_forces(const Liquid<Scheme>& liquid) {
    if (scene_.loaded_walls.empty()) return;
    const WallForces forces = WallForcesOf<Scheme>(liquid, scene_.gravity).all();
    for (const LoadedWall& loaded : scene_.loaded_walls) {
      const Vector2 force = forces[static_cast<std::size_t>(loaded.wall)];
      push(output.wall_force_x[loaded.name], liquid.time, force.x);
      push(output.wall_force_z[loaded.name], liquid.time, force.z);
    }
  }

  void record_energies(double t, const Motion<Scheme>& motion) {
    const Particles& p = seen_.particles;
    double potential = 0;
    Vector2 momentum{0, 0};
    for (std::size_t i = 0; i < p.size(); ++i) {
      potential += p.mass[i] * scene_.gravity * motion.in_earth().in_frame(p.x[i], p.z[i]).z;
      momentum.x += p.mass[i] * p.velocity_x[i];
      momentum.z += p.mass[i] * p.velocity_z[i];
    }
    momentum = motion.in_earth().along_frame(momentum.x, momentum.z);
    if (output.potential_energy.time.empty()) initial_potential_ = potential;
    push(output.kinetic_energy, t, kinetic_energy(p));
    push(output.potential_energy, t, potential - initial_potential_);
    push(output.momentum_x, t, momentum.x);
    push(output.momentum_z, t, momentum.z);
  }

  // The force on the tank is the reaction to the sum of all pushes, to which the walls alone
  // contribute.
  void record_forces(double t) {
    const Particles& p = seen_.particles;
    double force_x = 0, force_z = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
      force_x -= p.mass[i] * seen_.push_x[i];
      force_z -= p.mass[i] * seen_.push_z[i];
    }
    push(output.force_x, t, force_x);
    push(output.force_z, t, force_z);
    if (scene_.roll) push(output.moment, t, moment_about(scene_.roll->axis_x, scene_.roll->axis_z));
  }

  // Returns the moment [N] on a tank that rolls, counter-clockwise.
  double moment_about(double axis_x, double axis_z) const {
    const Particles& p = seen_.particles;
    double moment = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
      const double x = -p.mass[i] * seen_.push_x[i], z = -p.mass[i] * seen_.push_z[i];
      moment += (p.x[i] - axis_x) * z - (p.z[i] - axis_z) * x;
    }
    return moment;
  }

  void check_energy(double t, const Motion<Scheme>& motion) {
    const auto& kinetic = output.kinetic_energy.value;
    const double gained = kinetic.back() - kinetic.front() + output.potential_energy.value.back();
    const Vector2 axis = motion.in_earth().along_tank(scene_.velocity(t), 0);
    double power = output.force_x.value.back() * axis.x + output.force_z.value.back() * axis.z;
    if (scene_.roll) power += output.moment.value.back() * scene_.roll->rate(t);
    energy_bound_.check(t, gained, power, tank_speed(scene_, t), seen_.particles);
  }

  const Scene& scene_;
  LineOfSight sight_;
  std::vector<ColumnInOutline> columns_;  // of the gauges of a tank with an outline
  SeenFromTank seen_;
  EnergyBound energy_bound_;
  Soundness soundness_;
  double initial_potential_ = 0;
  std::optional<StillWater> still_water_;
  std::optional<EnergyBudget<Scheme>> energy_budget_;
};

}  // namespace slosh::sph

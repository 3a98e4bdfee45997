#include "sph/recording/recorder.hpp"

#include "sph/recording/free_surface.hpp"
#include "sph/recording/near_particles.hpp"
#include "sph/recording/probe.hpp"
#include "sph/recording/wall_forces.hpp"
#include "sph/recording/wall_power.hpp"
#include "sph/recording/wall_pressure_gauge.hpp"

namespace slosh::sph {
namespace {

void push(History& history, double time, double value) {
  history.time.push_back(time);
  history.value.push_back(value);
}

// Fills in `seen`; `motion` is the tank's at the liquid's time.
void see_from_tank(const Liquid& liquid, const TankMotion& motion, SeenFromTank& seen) {
  const Particles& p = liquid.particles;
  const Tank tank = liquid.tank_at(liquid.time);
  const double gravity = liquid.setting().gravity;
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

}  // namespace

Recorder::Recorder(const Scene& scene, Liquid& liquid)
    : scene_(scene), sight_(sight_of_instruments(scene)), energy_bound_(scene, liquid.particles) {
  if (const auto outline = outline_of(scene))
    for (const Gauge& gauge : scene.gauges)
      columns_.emplace_back(*outline, scene.fill_depth, gauge.x, scene.particle_spacing);
  for (const PressureGauge& gauge : scene.pressure_gauges) require_on_wall(gauge, scene);
  for (const Probe& probe : scene.probes) require_in_tank(probe, scene);
  if (scene.record_still_water)
    still_water_.emplace(scene, liquid.particles, [terms = liquid.method().terms](double density) {
      return terms->pressure(density);
    });
  if (scene.record_energy_budget) energy_budget_.emplace(liquid);
}

void Recorder::record(Liquid& liquid, bool is_last) {
  const TankMotion motion(scene_, liquid.time);
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

void Recorder::record_snapshot(const Liquid& liquid) const {
  const Particles& p = seen_.particles;
  const auto values = [](const Array<double>& field) {
    return std::vector<double>(field.begin(), field.end());
  };
  Snapshot snapshot{liquid.time,          values(p.x), values(p.z),      values(p.velocity_x),
                    values(p.velocity_z), {},          values(p.density)};
  for (const double density : p.density)
    snapshot.pressure.push_back(liquid.terms().pressure(density));
  scene_.record_snapshot(snapshot);
}

void Recorder::record_gauges(const Liquid& liquid, const TankMotion& motion) {
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
                       [&](double density) { return liquid.terms().pressure(density); }));
  if (scene_.column_width)
    push(output.front_position, t, front_position(p, scene_.particle_spacing));
}

void Recorder::record_probes(const Liquid& liquid, const TankMotion& motion) {
  for (const Probe& probe : scene_.probes) {
    const Probed found = probed(seen_.particles, probe, scene_, motion,
                                [&](double density) { return liquid.terms().pressure(density); });
    push(output.velocity_x[probe.name], liquid.time, found.velocity.x);
    push(output.velocity_z[probe.name], liquid.time, found.velocity.z);
    push(output.pressure[probe.name], liquid.time, found.pressure);
  }
}

// Reads the sources of the momentum sum, which the next evaluation of any other sum overwrites.
void Recorder::record_wall_forces(Liquid& liquid) {
  if (scene_.loaded_walls.empty()) return;
  const std::optional<TankOutline> outline = outline_of(scene_);
  const WallForces forces = wall_forces(liquid, outline ? &*outline : nullptr, scene_.gravity);
  for (const LoadedWall& loaded : scene_.loaded_walls) {
    const Vector2 force = forces[static_cast<std::size_t>(loaded.wall)];
    push(output.wall_force_x[loaded.name], liquid.time, force.x);
    push(output.wall_force_z[loaded.name], liquid.time, force.z);
  }
}

void Recorder::record_energies(double t, const TankMotion& motion) {
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
void Recorder::record_forces(double t) {
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
double Recorder::moment_about(double axis_x, double axis_z) const {
  const Particles& p = seen_.particles;
  double moment = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double x = -p.mass[i] * seen_.push_x[i], z = -p.mass[i] * seen_.push_z[i];
    moment += (p.x[i] - axis_x) * z - (p.z[i] - axis_z) * x;
  }
  return moment;
}

void Recorder::check_energy(double t, const TankMotion& motion) {
  const auto& kinetic = output.kinetic_energy.value;
  const double gained = kinetic.back() - kinetic.front() + output.potential_energy.value.back();
  const Vector2 axis = motion.in_earth().along_tank(scene_.velocity(t), 0);
  double power = output.force_x.value.back() * axis.x + output.force_z.value.back() * axis.z;
  if (scene_.roll) power += output.moment.value.back() * scene_.roll->rate(t);
  energy_bound_.check(t, gained, power, tank_speed(scene_, t), seen_.particles);
}

}  // namespace slosh::sph

// Records what the scene asks for, at its sample times.
#pragma once

#include <optional>

#include "sph/free_surface_gauge.hpp"
#include "sph/front_position.hpp"
#include "sph/liquid.hpp"
#include "sph/simulation.hpp"
#include "sph/stability_guard.hpp"
#include "sph/still_water.hpp"

namespace slosh::sph {

template <class Scheme>
class Recorder {
 public:
  Recorder(const Scene& scene, const Liquid<Scheme>& liquid)
      : scene_(scene), initial_potential_(potential(liquid)) {
    if (scene.record_still_water)
      still_water_.emplace(
          scene, liquid.particles,
          [state = liquid.scheme().state](double density) { return state.pressure(density); });
  }

  void record(const Liquid<Scheme>& liquid) {
    const Particles& p = liquid.particles;
    check_state(p, scene_.rest_density, liquid.time);
    const double wall = scene_.displacement(liquid.time);
    for (const Gauge& gauge : scene_.gauges)
      push(output.elevation[gauge.name], liquid.time,
           surface_elevation(p, wall, scene_.tank_length, scene_.fill_depth, gauge.x));
    if (scene_.column_width)
      push(output.front_position, liquid.time, front_position(p, wall, scene_.particle_spacing));
    if (still_water_) still_water_->record(p, wall, liquid.time, output.still_water);
    double force = 0;
    for (std::size_t i = 0; i < p.size(); ++i) force -= p.mass[i] * liquid.rates.acceleration_x[i];
    push(output.kinetic_energy, liquid.time, kinetic_energy(p));
    push(output.potential_energy, liquid.time, potential(liquid) - initial_potential_);
    // The walls' is the only horizontal force on the liquid, so its reaction is minus the
    // momentum's rate. Before the first step there is none.
    if (output.steps > 0) push(output.horizontal_force, liquid.time, force);
  }

  void record_snapshot(const Liquid<Scheme>& liquid) const {
    const Particles& p = liquid.particles;
    const double wall = scene_.displacement(liquid.time);
    Snapshot snapshot{liquid.time, {}, {}, {}, {}, {}, {}};
    snapshot.z.assign(p.z.begin(), p.z.end());
    snapshot.velocity_x.assign(p.velocity_x.begin(), p.velocity_x.end());
    snapshot.velocity_z.assign(p.velocity_z.begin(), p.velocity_z.end());
    snapshot.density.assign(p.density.begin(), p.density.end());
    for (std::size_t i = 0; i < p.size(); ++i) {
      snapshot.x.push_back(p.x[i] - wall);
      snapshot.pressure.push_back(liquid.scheme().state.pressure(p.density[i]));
    }
    scene_.record_snapshot(snapshot);
  }

  RunOutput output;

 private:
  static void push(History& history, double time, double value) {
    history.time.push_back(time);
    history.value.push_back(value);
  }
  static double potential(const Liquid<Scheme>& liquid) {
    double sum = 0;
    for (std::size_t i = 0; i < liquid.particles.size(); ++i)
      sum += liquid.particles.mass[i] * liquid.scheme().setting.gravity * liquid.particles.z[i];
    return sum;
  }

  const Scene& scene_;
  double initial_potential_;
  std::optional<StillWater> still_water_;
};

}  // namespace slosh::sph

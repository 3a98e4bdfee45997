// A liquid with a scheme's terms for a problem: a box, particles placed by the problem, no gravity
// unless given, and the scheme's own integrator with equal steps.
#pragma once

#include <cmath>
#include <optional>
#include <random>
#include <utility>

#include "sph/guards/stability_guard.hpp"
#include "sph/liquid.hpp"
#include "sph/scheme.hpp"
#include "sph/simulation.hpp"
#include "sph/start/initial_lattice.hpp"

namespace slosh {

struct Box {
  double length, height;                              // [m]
  double spacing;                                     // of the particles [m]
  double speed_of_sound;                              // [m/s]
  double viscosity = 0;                               // kinematic, of the liquid [m2/s]
  double gravity = 0;                                 // [m/s2]
  double velocity = 0;                                // of the box, along x [m/s]
  std::optional<double> smoothing_length_ratio = {};  // h / dp; empty: the scheme's own
  double rest_density = 1000;                         // [kg/m3]
};

inline sph::Scene scene_of(const Box& box) {
  return {.tank_length = box.length,
          .tank_height = box.height,
          .fill_depth = box.height,
          .gravity = box.gravity,
          .rest_density = box.rest_density,
          .kinematic_viscosity = box.viscosity,
          .displacement = [u = box.velocity](double t) { return u * t; },
          .velocity = [u = box.velocity](double) { return u; },
          .acceleration = [](double) { return 0.0; },
          .duration = 0,
          .sample_interval = 1,
          .particle_spacing = box.spacing,
          .surface_particle_spacing = box.spacing,
          .gauges = {},
          .record_snapshot = {}};
}

// Returns the scheme with its own numbers, except the speed of sound, as there is no wave speed to
// scale it by without gravity, and the density without pressure, which the box gives.
template <class Choice>
sph::Scheme<Choice> scheme_of(const Box& box) {
  sph::Setting setting = sph::setting_of(scene_of(box), Choice::numbers);
  setting.speed_of_sound = box.speed_of_sound;
  setting.rest_density = box.rest_density;
  if (box.smoothing_length_ratio) setting.smoothing_length_ratio = *box.smoothing_length_ratio;
  return sph::Scheme<Choice>(setting);
}

// Returns particles at rest and of the rest density, in the middles of those square cells of the
// box where `keep(x, z)` is true.
template <class Keep>
sph::Particles lattice(const Box& box, const Keep& keep) {
  sph::Particles p;
  const double dp = box.spacing;
  const auto columns = std::lround(box.length / dp), rows = std::lround(box.height / dp);
  for (long row = 0; row < rows; ++row)
    for (long column = 0; column < columns; ++column) {
      const double x = (static_cast<double>(column) + 0.5) * dp,
                   z = (static_cast<double>(row) + 0.5) * dp;
      if (!keep(x, z)) continue;
      p.x.push_back(x);
      p.z.push_back(z);
      p.velocity_x.push_back(0);
      p.velocity_z.push_back(0);
      p.density.push_back(box.rest_density);
      p.mass.push_back(box.rest_density * dp * dp);
      p.spacing.push_back(dp);
    }
  return p;
}

inline sph::Particles full_lattice(const Box& box) {
  return lattice(box, [](double, double) { return true; });
}

// Gives the particles random velocities of at most `largest` along x and along z [m/s], always the
// same.
inline void set_random_velocities(sph::Particles& p, double largest) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> speed(-largest, largest);
  for (std::size_t i = 0; i < p.size(); ++i) {
    p.velocity_x[i] = speed(random);
    p.velocity_z[i] = speed(random);
  }
}

// Gives a particle the density of a pressure, and the mass that fills its cell at that density.
template <class Scheme>
void set_pressure(const Scheme& scheme, sph::Particles& p, std::size_t i, double pressure) {
  const double density = scheme.state.density(pressure);
  p.mass[i] *= density / p.density[i];
  p.density[i] = density;
}

template <class Choice>
struct Flow {
  sph::Scene scene;
  sph::Liquid liquid;
  typename Choice::Integrator integrator = {};
  double steps = 0;

  Flow(const Box& box, sph::Particles particles)
      : scene(scene_of(box)),
        liquid(scene, method_of(scheme_of<Choice>(box)), std::move(particles)) {}
  Flow(const Flow&) = delete;  // the liquid refers to the scene
  Flow& operator=(const Flow&) = delete;

  void step(double dt) {
    integrator.advance(liquid, dt);
    liquid.time += dt;
    steps += 1;
  }

  // Takes equal steps, each at most the scheme's longest. Throws SimulationError for a state that
  // is not finite or out of its range.
  void advance_to(double time) {
    const double left = time - liquid.time;
    const double count = std::ceil(left / liquid.method().longest_step() - 1e-9);
    for (int i = 0; i < count; ++i) step(left / count);
    sph::check_state(liquid.particles, scene.rest_density, liquid.time);
  }
};

}  // namespace slosh

// The two flows that are timed, in a tank that is filled to half its height and twice as long as
// the liquid is deep.
//   calm     the first standing wave, with a height of 2 % of the depth
//   violent  vortices as large as the depth, at a twelfth of the speed of sound on a disordered
//            lattice; they renew the neighbour lists every one to three steps
#pragma once

#include <cmath>
#include <numbers>
#include <optional>
#include <random>
#include <string>

#include "sph/neighbours/particles.hpp"
#include "sph/simulation.hpp"
#include "sph/start/initial_lattice.hpp"

namespace slosh::sph {

enum class Flow { calm, violent };

// The lattice has `rows` rows of particles and twice as many columns.
inline Scene benchmark_scene(int rows, std::optional<double> smoothing_length_ratio) {
  const double depth = 0.5;
  Scene scene{.tank_length = 2 * depth,
              .tank_height = 2 * depth,
              .fill_depth = depth,
              .gravity = 9.81,
              .rest_density = 1000,
              .displacement = [](double) { return 0.0; },
              .velocity = [](double) { return 0.0; },
              .acceleration = [](double) { return 0.0; },
              .duration = 1,
              .sample_interval = 1,
              .particle_spacing = depth / rows,
              .surface_particle_spacing = depth / rows,
              .gauges = {},
              .record_snapshot = {}};
  scene.numbers.smoothing_length_ratio = smoothing_length_ratio;
  return scene;
}

inline void set_standing_wave(const Scene& scene, Particles& p) {
  const double k = std::numbers::pi / scene.tank_length, kh = k * scene.fill_depth;
  const double omega = std::sqrt(scene.gravity * k * std::tanh(kh));
  const double speed = 0.02 * scene.fill_depth * omega / std::sinh(kh);
  for (std::size_t i = 0; i < p.size(); ++i) {
    p.velocity_x[i] = speed * std::cosh(k * p.z[i]) * std::sin(k * p.x[i]);
    p.velocity_z[i] = -speed * std::sinh(k * p.z[i]) * std::cos(k * p.x[i]);
  }
}

inline void set_vortices(const Scene& scene, double speed_of_sound, Particles& p) {
  const double k = 2 * std::numbers::pi / scene.fill_depth, speed = speed_of_sound / 12;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> shift(-0.2 * scene.particle_spacing,
                                               0.2 * scene.particle_spacing);
  // Repulsive walls would eject a particle that is nearer to them than the lattice's particles.
  const double edge = scene.particle_spacing;
  const auto along_a_wall = [&](double x, double z) {
    return x < edge || x > scene.tank_length - edge || z < edge;
  };
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (!along_a_wall(p.x[i], p.z[i])) {
      p.x[i] += shift(random);
      p.z[i] += shift(random);
    }
    p.velocity_x[i] = speed * std::sin(k * p.x[i]) * std::cos(k * p.z[i]);
    p.velocity_z[i] = -speed * std::cos(k * p.x[i]) * std::sin(k * p.z[i]);
  }
}

template <class Scheme>
Particles flowing(const Scene& scene, const Scheme& scheme, Flow flow) {
  Particles particles =
      initial_lattice(scene, [&](double pressure) { return scheme.state.density(pressure); });
  if (flow == Flow::calm)
    set_standing_wave(scene, particles);
  else
    set_vortices(scene, scheme.setting.speed_of_sound, particles);
  return particles;
}

}  // namespace slosh::sph

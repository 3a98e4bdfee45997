// The liquid of one scheme: its particles, their neighbours, and the two right-hand sides that the
// integrators call.
#pragma once

#include <algorithm>
#include <cmath>

#include "sph/kernels.hpp"
#include "sph/neighbour_sources.hpp"
#include "sph/pair_sums.hpp"
#include "sph/particles.hpp"
#include "sph/simulation.hpp"
#include "sph/stability_guard.hpp"
#include "sph/tank_walls.hpp"

namespace slosh::sph {

template <class Scheme>
class Liquid {
 public:
  Particles particles;
  Rates rates;
  double time = 0;

  Liquid(const Scene& scene, const Scheme& scheme, Particles initial)
      : particles(std::move(initial)),
        scheme_(scheme),
        scene_(scene),
        neighbours_(walls_at(0), scene.particle_spacing, largest_support()) {
    renew_neighbours(0);
  }

  TankWalls walls_at(double t) const {
    const double x = scene_.displacement(t);
    return {x,
            x + scene_.tank_length,
            0,
            scene_.tank_height,
            scene_.velocity(t),
            scene_.acceleration(t)};
  }

  // Makes the neighbour search valid for a step of dt from now.
  void renew_neighbours(double dt) {
    const TankWalls walls = walls_at(time);
    scheme_.wall_contact.confine(particles, walls);
    if (!neighbours_.stale(particles, walls, dt)) return;
    if (!neighbours_.rebuild(particles, walls, dt))
      throw_bad_particle(particles, neighbours_.stray(), time, "outside the tank");
    rates.resize(particles.size());
  }

  void accelerate(double t) {
    const TankWalls walls = walls_at(t);
    neighbours_.refresh_for_momentum(scheme_, particles, walls);
    sum_momentum(scheme_, neighbours_, particles, rates, instructions_);
    scheme_.wall_contact.push(particles, walls, rates);
  }

  void compress(double t) {
    neighbours_.refresh_for_continuity(scheme_, particles, walls_at(t));
    sum_continuity(scheme_, neighbours_, particles, rates, instructions_);
  }

  const Scheme& scheme() const { return scheme_; }
  const NeighbourSources& neighbours() const { return neighbours_; }

 private:
  double largest_support() const {
    const double spacing = *std::max_element(particles.spacing.begin(), particles.spacing.end());
    return kernel_support / scheme_.smoothing.inverse(spacing, spacing);
  }

  Scheme scheme_;
  const Scene& scene_;
  NeighbourSources neighbours_;
  InstructionSet instructions_ = widest_instruction_set();
};

}  // namespace slosh::sph

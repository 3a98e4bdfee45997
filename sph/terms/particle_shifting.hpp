// Particle shifting: at the end of a step particles move a little down the gradient of their
// concentration, which keeps them evenly spread (Sun et al. 2017, eq. 12, delta-plus-SPH):
//   dr_a = -C Ma (2 h)^2 sum_b V_b [1 + 0.2 (W_ab / W(dp))^4] grad_a W_ab,   Ma = |v_a| / c0 here,
// C the Courant number; no farther than 0.05 dp. Particles near the free surface, where the
// gradient tells of the surface and not of the spread, stay: those whose div r = -sum_b V_b
// r_ab . grad_a W_ab is below 1.9 (2 inside the liquid; Lee et al. 2008).
#pragma once

#include <algorithm>
#include <cmath>

#include "sph/neighbours/density_gradient.hpp"
#include "sph/neighbours/neighbour_sources.hpp"
#include "sph/setting.hpp"

namespace slosh::sph {

struct NoShifting {
  static constexpr const char* name = "";
  static constexpr bool active = false;
};

struct ParticleShifting {
  static constexpr const char* name = "particle shifting, away from the free surface";
  static constexpr bool active = true;
};

struct Shifts {
  Array<double> x, z;  // [m]
};

template <class Scheme>
void shift_of_cluster(const Scheme* scheme, const Cluster* cluster, const Source* sources,
                      const Particles* particles, const double* tank_velocity, Shifts* shifts) {
  using Kernel = typename Scheme::Kernel;
  const Particles& p = *particles;
  const Setting& s = scheme->setting;
  const double inverse_h = scheme->smoothing.inverse_length, h = 1 / inverse_h;
  const double inverse_shape = 1 / Kernel::shape(1 / s.smoothing_length_ratio);
  const std::size_t i = cluster->first;
  const Lanes x = load(&p.x[i]), z = load(&p.z[i]);
  Lanes sum_x{}, sum_z{}, divergence{};
  for (std::size_t k = 0; k < cluster->source_count; ++k) {
    const Source& b = sources[cluster->sources[k]];
    const Lanes dx = x - b.x, dz = z - b.z, distance2 = dx * dx + dz * dz;
    const Lanes ratio = Kernel::shape(square_root(distance2) * inverse_h) * inverse_shape;
    const Lanes ratio2 = ratio * ratio;
    const Lanes f = b.weight * gradient_over_distance<Kernel>(distance2, inverse_h);
    divergence -= f * distance2;
    const Lanes g = f * (1.0 + 0.2 * ratio2 * ratio2);
    sum_x += g * dx;
    sum_z += g * dz;
  }
  for (std::size_t lane = 0; lane < cluster->size; ++lane) {
    const std::size_t a = i + lane;
    const double speed = std::hypot(p.velocity_x[a] - *tank_velocity, p.velocity_z[a]);
    const double scale =
        divergence[lane] > 1.9 ? -s.courant_number * speed / s.speed_of_sound * 4 * h * h : 0.0;
    const double dx = scale * sum_x[lane], dz = scale * sum_z[lane];
    const double most = 0.05 * s.particle_spacing, length = std::hypot(dx, dz);
    const double limit = length > most ? most / length : 1.0;
    shifts->x[a] = limit * dx;
    shifts->z[a] = limit * dz;
  }
}

template <class Scheme>
void sum_shifts(const Scheme& scheme, const NeighbourSources& neighbours,
                const Particles& particles, const TankWalls& walls, Shifts& shifts,
                InstructionSet set) {
  shifts.x.resize(particles.size());
  shifts.z.resize(particles.size());
  neighbours.clusters().for_each([&](const Cluster& cluster) {
    call<&shift_of_cluster<Scheme>>(set, &scheme, &cluster, neighbours.sources(), &particles,
                                    &walls.velocity, &shifts);
  });
}

}  // namespace slosh::sph

// Particle shifting: at the end of a step, particles move a little down the gradient of their
// concentration, which keeps their distribution even (Sun et al. 2017, eq. 12, delta-plus-SPH):
//   dr_a = -C Ma (2 h)^2 sum_b V_b / 2 [1 + 0.2 (W_ab / W(dp))^4] grad_a W_ab,   Ma = |v_a| / c0
// C is the Courant number, and a shift is limited to 0.05 dp. Near the free surface this gradient
// is that of the surface and not of the distribution. The shifts there (Sun et al. 2019, section 3)
// depend on the fullness lambda_a, the smaller eigenvalue of sum_b V_b (r_b - r_a) (x) grad_a W_ab,
// which is 1 inside the liquid and 1/2 on a flat surface:
//   lambda_a <= 0.75              the particle belongs to the surface and is not shifted
//   such a particle in reach      the particle is shifted along the surface only, perpendicular to
//                                 n ~ grad lambda
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "sph/neighbours/density_gradient.hpp"
#include "sph/neighbours/neighbour_sources.hpp"
#include "sph/setting.hpp"

namespace slosh::sph {

struct NoShifting {
  static constexpr const char* name = "";
  static constexpr bool active = false;
};

struct ParticleShifting {
  static constexpr const char* name = "particle shifting, along the free surface near to it";
  static constexpr bool active = true;
};

struct Shifts {
  Array<double> x, z;  // [m]
  Array<double> fullness;
  std::vector<double> fullness_of_sources;  // in their order; no_fullness for solids

  template <class Visit>
  void for_each_named_field(const Visit& visit) {
    visit("shift_x", x);
    visit("shift_z", z);
    visit("fullness", fullness);
    visit("fullness_of_sources", fullness_of_sources);
  }
};

inline constexpr double fullness_of_surface = 0.75;  // Sun et al. 2017, eq. 13
inline constexpr double no_fullness = -1;

template <class Scheme>
void fullness_of_cluster(const Scheme* scheme, const Cluster* cluster, const Source* sources,
                         const Particles* particles, Shifts* shifts) {
  const std::size_t i = cluster->first;
  const Lanes x = load(&particles->x[i]), z = load(&particles->z[i]);
  Renormalisation support;
  for (std::size_t k = 0; k < cluster->source_count; ++k) {
    const Source& b = sources[cluster->sources[k]];
    const Lanes dx = x - b.x, dz = z - b.z;
    const Lanes f = b.weight * gradient_over_distance<typename Scheme::Kernel>(
                                   dx * dx + dz * dz, scheme->smoothing.inverse_length);
    support.add(f, dx, dz);
  }
  const Lanes mean = 0.5 * (support.xx + support.zz), half = 0.5 * (support.xx - support.zz);
  store(&shifts->fullness[i], mean - square_root(half * half + support.xz * support.xz),
        cluster->size);
}

template <class Scheme>
void shift_of_cluster(const Scheme* scheme, const Cluster* cluster, const Source* sources,
                      const Particles* particles, const double* tank_velocity, Shifts* shifts) {
  using Kernel = typename Scheme::Kernel;
  const Particles& p = *particles;
  const Setting& s = scheme->setting;
  const double inverse_h = scheme->smoothing.inverse_length, h = 1 / inverse_h;
  const double inverse_shape = 1 / Kernel::shape(1 / s.smoothing_length_ratio);
  const std::size_t i = cluster->first;
  const Lanes x = load(&p.x[i]), z = load(&p.z[i]), fullness = load(&shifts->fullness[i]);
  Lanes sum_x{}, sum_z{}, normal_x{}, normal_z{}, surface_in_reach{};
  for (std::size_t k = 0; k < cluster->source_count; ++k) {
    const Source& b = sources[cluster->sources[k]];
    const Lanes dx = x - b.x, dz = z - b.z, distance2 = dx * dx + dz * dz;
    const Lanes ratio = Kernel::shape(square_root(distance2) * inverse_h) * inverse_shape;
    const Lanes ratio2 = ratio * ratio;
    const Lanes f = b.weight * gradient_over_distance<Kernel>(distance2, inverse_h);
    const Lanes g = f * (1.0 + 0.2 * ratio2 * ratio2);
    sum_x += g * dx;
    sum_z += g * dz;
    const double of_b = shifts->fullness_of_sources[cluster->sources[k]];
    if (of_b == no_fullness) continue;
    if (of_b <= fullness_of_surface) surface_in_reach -= f;
    normal_x += f * (of_b - fullness) * dx;
    normal_z += f * (of_b - fullness) * dz;
  }
  for (std::size_t lane = 0; lane < cluster->size; ++lane) {
    const std::size_t a = i + lane;
    const double speed = std::hypot(p.velocity_x[a] - *tank_velocity, p.velocity_z[a]);
    const double scale = fullness[lane] > fullness_of_surface
                             ? -s.courant_number * speed / s.speed_of_sound * 2 * h * h
                             : 0.0;
    double dx = scale * sum_x[lane], dz = scale * sum_z[lane];
    const double nx = normal_x[lane], nz = normal_z[lane];
    if (surface_in_reach[lane] > 0) {
      const double normal2 = nx * nx + nz * nz;  // 0 in the middle of a sheet
      const double across = normal2 > 0 ? (dx * nx + dz * nz) / normal2 : 0.0;
      dx -= across * nx;
      dz -= across * nz;
    }
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
  for (auto* field : {&shifts.x, &shifts.z, &shifts.fullness}) field->resize(particles.size());
  neighbours.clusters().for_each([&](const Cluster& cluster) {
    call<&fullness_of_cluster<Scheme>>(set, &scheme, &cluster, neighbours.sources(), &particles,
                                       &shifts);
  });
  shifts.fullness_of_sources.resize(neighbours.source_count());
  neighbours.for_each_image<typename Scheme::Mirror>(
      walls, [&](std::size_t k, std::size_t i, const MirrorMap&) {
        shifts.fullness_of_sources[k] = shifts.fullness[i];
      });
  for (std::size_t k = neighbours.first_solid_source(); k < neighbours.source_count(); ++k)
    shifts.fullness_of_sources[k] = no_fullness;
  neighbours.clusters().for_each([&](const Cluster& cluster) {
    call<&shift_of_cluster<Scheme>>(set, &scheme, &cluster, neighbours.sources(), &particles,
                                    &walls.velocity, &shifts);
  });
}

}  // namespace slosh::sph

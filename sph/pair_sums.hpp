// The sums over neighbours: the momentum and the continuity equation. For particle a over its
// sources b,
//   dv_a/dt   = -A_a sum_b w_b (s_a + s_b + viscous_ab) grad_a W_ab          (plus gravity)
//   drho_a/dt =  C_a sum_b w_b (v_a - v_b) . grad_a W_ab + sum_b V_b diffusion_ab (dW/dr)/r
// with the factors of formulation.hpp.
#pragma once

#include "sph/cluster_lists.hpp"
#include "sph/instruction_sets.hpp"
#include "sph/lanes.hpp"
#include "sph/neighbour_sources.hpp"
#include "sph/particles.hpp"

namespace slosh::sph {

// (dW/dr)/r of a pair [1/m4]; `inverse_h` [1/m].
template <class Kernel, class Length>
inline Lanes gradient_over_distance(Lanes distance2, Length inverse_h) {
  const Length inverse_h2 = inverse_h * inverse_h;
  return Kernel::normalisation * inverse_h2 * inverse_h2 *
         Kernel::gradient_shape(square_root(distance2) * inverse_h);
}

template <class Scheme>
void momentum_of_cluster(const Scheme* scheme, const Cluster* cluster, const Source* sources,
                         const Particles* particles, Rates* rates) {
  using Viscosity = typename Scheme::Viscosity;
  const Particles& p = *particles;
  const std::size_t i = cluster->first;
  const Lanes x = load(&p.x[i]), z = load(&p.z[i]), u = load(&p.velocity_x[i]),
              w = load(&p.velocity_z[i]), rho = load(&p.density[i]);
  const Lanes spacing = Scheme::Smoothing::reads_spacing ? load(&p.spacing[i]) : Lanes{};
  const Lanes strength = scheme->formulation.strength(scheme->state.pressure(rho), rho);
  Lanes sum_x{}, sum_z{};
  for (std::size_t k = 0; k < cluster->source_count; ++k) {
    const Source& b = sources[cluster->sources[k]];
    const Lanes dx = x - b.x, dz = z - b.z, distance2 = dx * dx + dz * dz;
    const auto inverse_h = scheme->smoothing.inverse(spacing, b.spacing);
    Lanes s = strength + b.strength;
    if constexpr (Viscosity::active) {
      const Lanes approach = (u - b.velocity_x) * dx + (w - b.velocity_z) * dz;
      s += scheme->viscosity.pair(approach, distance2, 1.0 / inverse_h) *
           scheme->formulation.viscous_scale(rho, b.density);
    }
    const Lanes f =
        b.weight * s * gradient_over_distance<typename Scheme::Kernel>(distance2, inverse_h);
    sum_x += f * dx;
    sum_z += f * dz;
  }
  const auto factor = scheme->formulation.acceleration_factor(rho);
  store(&rates->acceleration_x[i], -factor * sum_x, cluster->size);
  store(&rates->acceleration_z[i], -factor * sum_z - scheme->gravity, cluster->size);
}

template <class Scheme>
void continuity_of_cluster(const Scheme* scheme, const Cluster* cluster, const Source* sources,
                           const Particles* particles, Rates* rates) {
  using Diffusion = typename Scheme::DensityDiffusion;
  const Particles& p = *particles;
  const std::size_t i = cluster->first;
  const Lanes x = load(&p.x[i]), z = load(&p.z[i]), u = load(&p.velocity_x[i]),
              w = load(&p.velocity_z[i]), rho = load(&p.density[i]);
  const Lanes spacing = Scheme::Smoothing::reads_spacing ? load(&p.spacing[i]) : Lanes{};
  Lanes own{}, divergence{}, diffusion{};
  if constexpr (Diffusion::active) own = scheme->density_diffusion.diffused(rho, z);
  for (std::size_t k = 0; k < cluster->source_count; ++k) {
    const Source& b = sources[cluster->sources[k]];
    const Lanes dx = x - b.x, dz = z - b.z;
    const auto inverse_h = scheme->smoothing.inverse(spacing, b.spacing);
    const Lanes f =
        b.weight * gradient_over_distance<typename Scheme::Kernel>(dx * dx + dz * dz, inverse_h);
    divergence += f * ((u - b.velocity_x) * dx + (w - b.velocity_z) * dz);
    if constexpr (Diffusion::active)
      diffusion += f * scheme->density_diffusion.pair(own - b.density, 1.0 / inverse_h);
  }
  store(&rates->density_rate[i],
        scheme->formulation.continuity_factor(rho) * divergence + diffusion, cluster->size);
}

// Calls one of the two above for every cluster, in its build for `set`.
template <auto of_cluster, class Scheme>
void for_each_cluster(const Scheme& scheme, const NeighbourSources& neighbours,
                      const Particles& particles, Rates& rates, InstructionSet set) {
  neighbours.clusters().for_each([&](const Cluster& cluster) {
    call<of_cluster>(set, &scheme, &cluster, neighbours.sources(), &particles, &rates);
  });
}

template <class Scheme>
void sum_momentum(const Scheme& scheme, const NeighbourSources& neighbours,
                  const Particles& particles, Rates& rates, InstructionSet set) {
  for_each_cluster<&momentum_of_cluster<Scheme>>(scheme, neighbours, particles, rates, set);
}

template <class Scheme>
void sum_continuity(const Scheme& scheme, const NeighbourSources& neighbours,
                    const Particles& particles, Rates& rates, InstructionSet set) {
  for_each_cluster<&continuity_of_cluster<Scheme>>(scheme, neighbours, particles, rates, set);
}

}  // namespace slosh::sph

// The sums over neighbours: the momentum and the continuity equation. For particle a over its
// sources b,
//   dv_a/dt   = -A_a sum_b w_b (s_a + s_b + viscous_ab) grad_a W_ab          (plus gravity)
//   drho_a/dt =  C_a sum_b w_b (v_a - v_b) . grad_a W_ab + sum_b V_b diffusion_ab (dW/dr)/r
// with the factors of terms/formulation.hpp.
#pragma once

#include "sph/neighbours/cluster_lists.hpp"
#include "sph/neighbours/density_gradient.hpp"
#include "sph/neighbours/instruction_sets.hpp"
#include "sph/neighbours/lanes.hpp"
#include "sph/neighbours/particles.hpp"
#include "sph/neighbours/two_sources.hpp"
#include "sph/terms/kernels.hpp"

namespace slosh::sph {

// (dW/dr)/r of a pair without the factors that all pairs share; the whole sum is multiplied by
// these (shared_scale).
template <class Scheme, class Number, class Length>
inline Number pair_gradient(Number distance2, Length inverse_h) {
  using Kernel = typename Scheme::Kernel;
  const Number shape = gradient_shape_of_pair<Kernel>(distance2, inverse_h);
  if constexpr (Scheme::Smoothing::reads_spacing)
    return gradient_scale<Kernel>(inverse_h) * shape;
  else
    return shape;
}
template <class Scheme>
inline double shared_scale(const Scheme& scheme) {
  if constexpr (Scheme::Smoothing::reads_spacing)
    return 1.0;
  else
    return gradient_scale<typename Scheme::Kernel>(scheme.smoothing.inverse_length);
}

template <class Scheme>
using Tank = typename Scheme::Frame::Tank;

// The state of the particles in the lanes; `spacing` is 0 where the scheme does not read it.
template <Vector Number>
struct LaneState {
  Number x, z, u, w, rho, spacing;
};
template <class Scheme, Vector Number>
LaneState<Number> state_at(const Particles& p, std::size_t i) {
  return {load<Number>(&p.x[i]),
          load<Number>(&p.z[i]),
          load<Number>(&p.velocity_x[i]),
          load<Number>(&p.velocity_z[i]),
          load<Number>(&p.density[i]),
          Scheme::Smoothing::reads_spacing ? load<Number>(&p.spacing[i]) : Number{}};
}

// The gradients of one source or of two.
inline SourceGradient gradient_of(const DensityGradient& gradient, const Cluster& cluster,
                                  std::size_t k, const Source&) {
  return gradient.of_sources[cluster.sources[k]];
}
struct TwoGradients {
  Two<double> x, z;
};
inline TwoGradients gradient_of(const DensityGradient& gradient, const Cluster& cluster,
                                std::size_t k, const TwoSources&) {
  const SourceGradient &first = gradient.of_sources[cluster.sources[k]],
                       &second = gradient.of_sources[cluster.sources[k + 1]];
  return {{first.x, second.x}, {first.z, second.z}};
}

template <class Scheme>
struct MomentumOfCluster {
  template <Vector Number>
  static void run(const Scheme* scheme, const Tank<Scheme>* tank, const Cluster* cluster,
                  const Source* sources, const Particles* particles, Rates* rates) {
    using Viscosity = typename Scheme::Viscosity;
    for (std::size_t i = cluster->first; i < cluster->first + cluster->size;
         i += lanes_of<Number>) {
      const std::size_t count = cluster->first + cluster->size - i;
      const auto [x, z, u, w, rho, spacing] = state_at<Scheme, Number>(*particles, i);
      const Number strength = scheme->formulation.strength(scheme->state.pressure(rho), rho);
      Number sum_x{}, sum_z{};
      const auto add = [&](const auto& b, std::size_t) {
        const auto dx = x - b.x, dz = z - b.z, distance2 = dx * dx + dz * dz;
        const auto inverse_h = scheme->smoothing.inverse(spacing, b.spacing);
        auto s = strength + b.strength;
        if constexpr (Viscosity::active) {
          const auto approach = (u - b.velocity_x) * dx + (w - b.velocity_z) * dz;
          s += scheme->viscosity.pair(approach, distance2, 1.0 / inverse_h) *
               scheme->formulation.viscous_scale(rho, b.density);
        }
        const auto f = b.weight * s * pair_gradient<Scheme>(distance2, inverse_h);
        sum_x += f * dx;
        sum_z += f * dz;
      };
      for_two_sources_each(*cluster, sources, cluster->source_count, add);
      const auto factor = shared_scale(*scheme) * scheme->formulation.acceleration_factor(rho);
      Number acceleration_x = -factor * sum_x, acceleration_z = -factor * sum_z;
      tank->pull(scheme->setting.gravity, x, z, u, w, acceleration_x, acceleration_z);
      store(&rates->acceleration_x[i], acceleration_x, count);
      store(&rates->acceleration_z[i], acceleration_z, count);
    }
  }
};

template <class Scheme>
struct ContinuityOfCluster {
  template <Vector Number>
  static void run(const Scheme* scheme, const Tank<Scheme>* tank, const Cluster* cluster,
                  const Source* sources, const DensityGradient* gradient,
                  const Particles* particles, Rates* rates) {
    using Diffusion = typename Scheme::DensityDiffusion;
    for (std::size_t i = cluster->first; i < cluster->first + cluster->size;
         i += lanes_of<Number>) {
      const std::size_t count = cluster->first + cluster->size - i;
      const auto [x, z, u, w, rho, spacing] = state_at<Scheme, Number>(*particles, i);
      Number own{}, gradient_x{}, gradient_z{}, divergence{}, diffusion{};
      if constexpr (Diffusion::active)
        own = scheme->density_diffusion.diffused(scheme->state.pressure(rho), rho,
                                                 tank->height(x, z));
      if constexpr (Diffusion::reads_gradient) {
        gradient_x = load<Number>(&gradient->x[i]);
        gradient_z = load<Number>(&gradient->z[i]);
      }
      const auto add = [&](const auto& b, [[maybe_unused]] std::size_t k) {
        const auto dx = x - b.x, dz = z - b.z;
        const auto inverse_h = scheme->smoothing.inverse(spacing, b.spacing);
        const auto f = b.weight * pair_gradient<Scheme>(dx * dx + dz * dz, inverse_h);
        divergence += f * ((u - b.velocity_x) * dx + (w - b.velocity_z) * dz);
        if constexpr (Diffusion::active) {
          auto difference = own - b.density;
          if constexpr (Diffusion::reads_gradient) {
            const auto of_b = gradient_of(*gradient, *cluster, k, b);
            difference -= 0.5 * ((gradient_x + of_b.x) * dx + (gradient_z + of_b.z) * dz);
          }
          diffusion += f * difference;
        }
      };
      for_two_sources_each(*cluster, sources, cluster->source_count, add);
      if constexpr (Diffusion::active)
        diffusion =
            scheme->density_diffusion.pair(diffusion, 1.0 / scheme->smoothing.inverse_length);
      store(&rates->density_rate[i],
            shared_scale(*scheme) * (scheme->formulation.continuity_factor(rho) * divergence +
                                     scheme->formulation.volume_of_weight * diffusion),
            count);
    }
  }
};

template <class Scheme>
void sum_momentum(const Scheme& scheme, const Tank<Scheme>& tank, const ClusterLists& clusters,
                  const Source* sources, const Particles& particles, Rates& rates,
                  InstructionSet set) {
  clusters.for_each([&](const Cluster& cluster) {
    call_in_registers<MomentumOfCluster<Scheme>>(set, &scheme, &tank, &cluster, sources, &particles,
                                                 &rates);
  });
}

// `gradient` may be empty unless the scheme's density diffusion reads it.
template <class Scheme>
void sum_continuity(const Scheme& scheme, const Tank<Scheme>& tank, const ClusterLists& clusters,
                    const Source* sources, const DensityGradient& gradient,
                    const Particles& particles, Rates& rates, InstructionSet set) {
  clusters.for_each([&](const Cluster& cluster) {
    call_in_registers<ContinuityOfCluster<Scheme>>(set, &scheme, &tank, &cluster, sources,
                                                   &gradient, &particles, &rates);
  });
}

}  // namespace slosh::sph

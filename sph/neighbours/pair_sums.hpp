// The sums over neighbours: the momentum and the continuity equation. For particle a over its
// sources b,
//   dv_a/dt   = -A_a sum_b w_b (s_a + s_b + viscous_ab) grad_a W_ab          (plus gravity)
//   drho_a/dt =  C_a sum_b w_b (v_a - v_b) . grad_a W_ab + sum_b V_b diffusion_ab (dW/dr)/r
// with the factors of terms/formulation.hpp. A loop is a template of the policies that it reads
// alone, so that schemes that differ in others share it.
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
template <class Kernel, class Smoothing, class Number, class Length>
inline Number pair_gradient(Number distance2, Length inverse_h) {
  const Number shape = gradient_shape_of_pair<Kernel>(distance2, inverse_h);
  if constexpr (Smoothing::reads_spacing)
    return gradient_scale<Kernel>(inverse_h) * shape;
  else
    return shape;
}
template <class Kernel, class Smoothing>
inline double shared_scale(const Smoothing& smoothing) {
  if constexpr (Smoothing::reads_spacing)
    return 1.0;
  else
    return gradient_scale<Kernel>(smoothing.inverse_length);
}

// The state of the particles in the lanes; `spacing` is 0 where the scheme does not read it.
template <Vector Number>
struct LaneState {
  Number x, z, u, w, rho, spacing;
};
template <class Smoothing, Vector Number>
LaneState<Number> state_at(const Particles& p, std::size_t i) {
  return {load<Number>(&p.x[i]),
          load<Number>(&p.z[i]),
          load<Number>(&p.velocity_x[i]),
          load<Number>(&p.velocity_z[i]),
          load<Number>(&p.density[i]),
          Smoothing::reads_spacing ? load<Number>(&p.spacing[i]) : Number{}};
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

// Sets the accelerations to gravity and the inertial forces of the tank's frame.
void set_to_pull(const Tank& tank, double gravity, const Particles& particles, Rates& rates,
                 InstructionSet set);

// Adds to the accelerations.
template <class Kernel, class Smoothing, class Formulation, class EquationOfState, class Viscosity>
struct MomentumOfCluster {
  Smoothing smoothing;
  Formulation formulation;
  EquationOfState state;
  Viscosity viscosity;

  template <Vector Number>
  static void run(const MomentumOfCluster* shared, const Cluster* cluster, const Source* sources,
                  const Particles* particles, Rates* rates) {
    const MomentumOfCluster terms = *shared;  // a copy, which the loop cannot change
    for (std::size_t i = cluster->first; i < cluster->first + cluster->size;
         i += lanes_of<Number>) {
      const std::size_t count = cluster->first + cluster->size - i;
      const LaneState<Number> a = state_at<Smoothing, Number>(*particles, i);
      const Number strength = terms.formulation.strength(terms.state.pressure(a.rho), a.rho);
      Number sum_x{}, sum_z{};
      const auto add = [&](const auto& b, std::size_t) {
        const auto dx = a.x - b.x, dz = a.z - b.z, distance2 = dx * dx + dz * dz;
        const auto inverse_h = terms.smoothing.inverse(a.spacing, b.spacing);
        auto s = strength + b.strength;
        if constexpr (Viscosity::active) {
          const auto approach = (a.u - b.velocity_x) * dx + (a.w - b.velocity_z) * dz;
          s += terms.viscosity.pair(approach, distance2, 1.0 / inverse_h) *
               terms.formulation.viscous_scale(a.rho, b.density);
        }
        const auto f = b.weight * s * pair_gradient<Kernel, Smoothing>(distance2, inverse_h);
        sum_x += f * dx;
        sum_z += f * dz;
      };
      for_two_sources_each(*cluster, sources, cluster->source_count, add);
      const auto factor =
          shared_scale<Kernel>(terms.smoothing) * terms.formulation.acceleration_factor(a.rho);
      const Number pull_x = load<Number>(&rates->acceleration_x[i]),
                   pull_z = load<Number>(&rates->acceleration_z[i]);
      store(&rates->acceleration_x[i], -factor * sum_x + pull_x, count);
      store(&rates->acceleration_z[i], -factor * sum_z + pull_z, count);
    }
  }
};

template <class Kernel, class Smoothing, class Formulation, class EquationOfState, class Diffusion>
struct ContinuityOfCluster {
  Smoothing smoothing;
  Formulation formulation;
  EquationOfState state;
  Diffusion diffusion;

  template <Vector Number>
  static void run(const ContinuityOfCluster* shared, const Tank* tank, const Cluster* cluster,
                  const Source* sources, const DensityGradient* gradient,
                  const Particles* particles, Rates* rates) {
    const ContinuityOfCluster terms = *shared;
    for (std::size_t i = cluster->first; i < cluster->first + cluster->size;
         i += lanes_of<Number>) {
      const std::size_t count = cluster->first + cluster->size - i;
      const LaneState<Number> a = state_at<Smoothing, Number>(*particles, i);
      Number own{}, gradient_x{}, gradient_z{}, divergence{}, diffusion{};
      if constexpr (Diffusion::active)
        own = terms.diffusion.diffused(terms.state.pressure(a.rho), a.rho, tank->height(a.x, a.z));
      if constexpr (Diffusion::reads_gradient) {
        gradient_x = load<Number>(&gradient->x[i]);
        gradient_z = load<Number>(&gradient->z[i]);
      }
      const auto add = [&](const auto& b, [[maybe_unused]] std::size_t k) {
        const auto dx = a.x - b.x, dz = a.z - b.z;
        const auto inverse_h = terms.smoothing.inverse(a.spacing, b.spacing);
        const auto f = b.weight * pair_gradient<Kernel, Smoothing>(dx * dx + dz * dz, inverse_h);
        divergence += f * ((a.u - b.velocity_x) * dx + (a.w - b.velocity_z) * dz);
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
        diffusion = terms.diffusion.pair(diffusion, 1.0 / terms.smoothing.inverse_length);
      store(&rates->density_rate[i],
            shared_scale<Kernel>(terms.smoothing) *
                (terms.formulation.continuity_factor(a.rho) * divergence +
                 terms.formulation.volume_of_weight * diffusion),
            count);
    }
  }
};

template <class Terms>
using MomentumOf = MomentumOfCluster<typename Terms::Kernel, typename Terms::Smoothing,
                                     typename Terms::Formulation, typename Terms::EquationOfState,
                                     typename Terms::Viscosity>;

template <class Terms>
MomentumOf<Terms> momentum_of(const Terms& terms) {
  return {terms.smoothing, terms.formulation, terms.state, terms.viscosity};
}

template <class Terms>
void sum_momentum(const Terms& terms, const Tank& tank, const ClusterLists& clusters,
                  const Source* sources, const Particles& particles, Rates& rates,
                  InstructionSet set) {
  const MomentumOf<Terms> momentum = momentum_of(terms);
  set_to_pull(tank, terms.setting.gravity, particles, rates, set);
  clusters.for_each([&](const Cluster& cluster) {
    call_in_registers<MomentumOf<Terms>>(set, &momentum, &cluster, sources, &particles, &rates);
  });
}

// `gradient` may be empty unless the density diffusion reads it.
template <class Terms>
void sum_continuity(const Terms& terms, const Tank& tank, const ClusterLists& clusters,
                    const Source* sources, const DensityGradient& gradient,
                    const Particles& particles, Rates& rates, InstructionSet set) {
  using Continuity =
      ContinuityOfCluster<typename Terms::Kernel, typename Terms::Smoothing,
                          typename Terms::Formulation, typename Terms::EquationOfState,
                          typename Terms::DensityDiffusion>;
  const Continuity continuity{terms.smoothing, terms.formulation, terms.state,
                              terms.density_diffusion};
  clusters.for_each([&](const Cluster& cluster) {
    call_in_registers<Continuity>(set, &continuity, &tank, &cluster, sources, &gradient, &particles,
                                  &rates);
  });
}

}  // namespace slosh::sph

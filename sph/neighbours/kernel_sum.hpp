// The kernel sum sum_b V_b W_ab over the sources b of a particle a, itself included. It is 1 where
// the particles' volumes fill the space around a particle.
#pragma once

#include "sph/neighbours/cluster_lists.hpp"
#include "sph/neighbours/instruction_sets.hpp"
#include "sph/neighbours/lanes.hpp"
#include "sph/neighbours/particles.hpp"
#include "sph/terms/kernels.hpp"

namespace slosh::sph {

template <class Kernel, class Smoothing, class Formulation>
struct KernelSumOfCluster {
  Smoothing smoothing;
  Formulation formulation;

  template <Vector Number>
  static void run(const KernelSumOfCluster* terms, const Cluster* cluster, const Source* sources,
                  const Particles* particles, Array<double>* sums) {
    for (std::size_t i = cluster->first; i < cluster->first + cluster->size;
         i += lanes_of<Number>) {
      const std::size_t count = cluster->first + cluster->size - i;
      const Number x = load<Number>(&particles->x[i]), z = load<Number>(&particles->z[i]);
      Number spacing{};
      if constexpr (Smoothing::reads_spacing) spacing = load<Number>(&particles->spacing[i]);
      Number sum{};
      for (std::size_t k = 0; k < cluster->source_count; ++k) {
        const Source& b = cluster->source(sources, k);
        const Number dx = x - b.x, dz = z - b.z;
        const auto inverse_h = terms->smoothing.inverse(spacing, b.spacing);
        const auto weight = terms->formulation.volume(b.weight, b.density) * inverse_h * inverse_h;
        sum += weight * shape_of_pair<Kernel>(Number(dx * dx + dz * dz), inverse_h);
      }
      store(&(*sums)[i], Kernel::normalisation * sum, count);
    }
  }
};

// The sources must have the state that the momentum sum reads.
template <class Terms>
void sum_kernel(const Terms& terms, const ClusterLists& clusters, const Source* sources,
                const Particles& particles, Array<double>& sums, InstructionSet set) {
  using KernelSum = KernelSumOfCluster<typename Terms::Kernel, typename Terms::Smoothing,
                                       typename Terms::Formulation>;
  const KernelSum kernel_sum{terms.smoothing, terms.formulation};
  clusters.for_each([&](const Cluster& cluster) {
    call_in_registers<KernelSum>(set, &kernel_sum, &cluster, sources, &particles, &sums);
  });
}

}  // namespace slosh::sph

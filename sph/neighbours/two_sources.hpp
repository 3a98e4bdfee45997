// A cluster's sources, two at a time (two.hpp).
#pragma once

#include <cstddef>

#include "sph/neighbours/cluster_lists.hpp"
#include "sph/neighbours/particles.hpp"
#include "sph/neighbours/two.hpp"

namespace slosh::sph {

struct TwoSources {
  Two<double> x, z, velocity_x, velocity_z, weight, strength, density, spacing;

  TwoSources(const Source& a, const Source& b)
      : x{a.x, b.x},
        z{a.z, b.z},
        velocity_x{a.velocity_x, b.velocity_x},
        velocity_z{a.velocity_z, b.velocity_z},
        weight{a.weight, b.weight},
        strength{a.strength, b.strength},
        density{a.density, b.density},
        spacing{a.spacing, b.spacing} {}
};

// Calls visit(b, k) for the first `count` sources of the cluster's list, where b is two of them,
// number k and k + 1, or the last one alone.
template <class Visit>
void for_two_sources_each(const Cluster& cluster, const Source* sources, std::size_t count,
                          const Visit& visit) {
  std::size_t k = 0;
  for (; k + 1 < count; k += 2)
    visit(TwoSources(cluster.source(sources, k), cluster.source(sources, k + 1)), k);
  if (k < count) visit(cluster.source(sources, k), k);
}

}  // namespace slosh::sph

// The liquid's state at the nodes of solid particles, by a linear least-squares fit over the
// kernel's support (moving least squares, as in Marrone et al. 2011, eq. 12). The fit's value at
// the node follows from the moments sum_b V_b W_ab (1, dx, dz)(1, dx, dz)^T over liquid and images.
// Where the particles do not determine a linear fit (a splash), the weighted mean is used. A node
// without liquid in its support has no state. The sums are over the liquid and its images, which
// come before the solids in every list.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "sph/neighbours/instruction_sets.hpp"
#include "sph/neighbours/lanes.hpp"
#include "sph/neighbours/neighbour_sources.hpp"
#include "sph/neighbours/two_sources.hpp"
#include "sph/terms/kernels.hpp"
#include "sph/walls/solid_particles.hpp"
#include "sph/walls/tank_walls.hpp"

namespace slosh::sph {

struct NodeSum {
  bool found = false;  // any liquid within the support
  double liquid = 0;   // its kernel sum, without the kernel's normalisation and 1/h^2
  double value = 0, velocity_x = 0, velocity_z = 0;
};

// The moments' matrix and what the fit's value at the node needs of it.
template <Vector Number>
struct NodeMoments {
  Number m{}, x{}, z{}, xx{}, xz{}, zz{};

  template <class NumberOrTwo>
  void add(NumberOrTwo weight, NumberOrTwo dx, NumberOrTwo dz) {
    m += weight;
    x += weight * dx;
    z += weight * dz;
    xx += weight * dx * dx;
    xz += weight * dx * dz;
    zz += weight * dz * dz;
  }
};
template <Vector Number>
struct NodeProjection {
  Number f{}, x{}, z{};

  template <class NumberOrTwo, class Value>
  void add(NumberOrTwo weight, NumberOrTwo dx, NumberOrTwo dz, Value value) {
    f += weight * value;
    x += weight * dx * value;
    z += weight * dz * value;
  }
  // Returns the fit's value at the nodes; h is the smoothing length [m].
  Number value(const NodeMoments<Number>& s, double h) const {
    // a, b and c are the cofactors of the first row of the moments' matrix.
    const Number a = s.xx * s.zz - s.xz * s.xz, b = s.xz * s.z - s.x * s.zz,
                 c = s.x * s.xz - s.xx * s.z;
    const Number determinant = s.m * a + s.x * b + s.z * c;
    // With a full support the determinant is about 0.01 m^3 h^4.
    const double least = 1e-3 * h * h * h * h;
    const auto fitted = determinant > least * s.m * s.m * s.m;
    return (fitted ? f * a + x * b + z * c : f) / (fitted ? determinant : s.m);
  }
};

// The field `value` of one source or of two.
template <double Source::*value>
double value_of(const Source& b) {
  return b.*value;
}
template <double Source::*value>
Two<double> value_of(const TwoSources& b) {
  static_assert(value == &Source::strength || value == &Source::density);
  return value == &Source::strength ? b.strength : b.density;
}

// Returns how many of the cluster's sources are liquid or images, which come first.
inline std::size_t liquid_sources(const Cluster& cluster, std::size_t first_solid_source) {
  const std::uint32_t* end = cluster.sources + cluster.source_count;
  return static_cast<std::size_t>(std::lower_bound(cluster.sources, end, first_solid_source) -
                                  cluster.sources);
}

// The template depends on the kernel and not on the scheme, so that schemes share its builds.
template <class Kernel, double Source::*value>
struct SumAtNodesOfCluster {
  template <Vector Number>
  static void run(double smoothing_length, const Cluster* cluster, const Source* sources,
                  std::size_t first_solid_source, const SolidPlace* places, const TankWalls* walls,
                  NodeSum* nodes) {
    const std::size_t sources_of_liquid = liquid_sources(*cluster, first_solid_source);
    for (std::size_t first = cluster->first; first < cluster->first + cluster->size;
         first += lanes_of<Number>) {
      const std::size_t count = std::min(lanes_of<Number>, cluster->first + cluster->size - first);
      if (sources_of_liquid == 0) {
        std::fill_n(nodes + first, count, NodeSum{});
        continue;
      }
      Number node_x{}, node_z{};
      for (std::size_t i = 0; i < count; ++i) {
        node_x[i] = walls->left + places[first + i].node_x;
        node_z[i] = walls->bottom + places[first + i].node_z;
      }
      NodeMoments<Number> moments;
      NodeProjection<Number> field, u, w;
      const auto add = [&](const auto& b, std::size_t) {
        const auto dx = b.x - node_x, dz = b.z - node_z;
        const auto weight =
            b.weight * shape_of_pair<Kernel>(dx * dx + dz * dz, 1.0 / smoothing_length);
        moments.add(weight, dx, dz);
        field.add(weight, dx, dz, value_of<value>(b));
        u.add(weight, dx, dz, b.velocity_x);
        w.add(weight, dx, dz, b.velocity_z);
      };
      for_two_sources_each(*cluster, sources, sources_of_liquid, add);
      const Number value_at = field.value(moments, smoothing_length),
                   u_at = u.value(moments, smoothing_length),
                   w_at = w.value(moments, smoothing_length);
      for (std::size_t i = 0; i < count; ++i)
        nodes[first + i] = moments.m[i] > 0
                               ? NodeSum{true, moments.m[i], value_at[i], u_at[i], w_at[i]}
                               : NodeSum{};
    }
  }
};

// Evaluates the velocity and the sources' field `value` at the nodes.
template <double Source::*value, class Scheme>
void sum_at_nodes(const Scheme& scheme, const NeighbourSources& neighbours,
                  const std::vector<SolidPlace>& places, const TankWalls& walls,
                  std::vector<NodeSum>& nodes, InstructionSet set) {
  neighbours.solid_clusters().for_each([&](const Cluster& cluster) {
    call_in_registers<SumAtNodesOfCluster<typename Scheme::Kernel, value>>(
        set, scheme.setting.smoothing_length(), &cluster, neighbours.sources(),
        neighbours.first_solid_source(), places.data(), &walls, nodes.data());
  });
}

}  // namespace slosh::sph

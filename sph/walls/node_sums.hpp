// The liquid's state at the nodes of solid particles, by a linear least-squares fit over the
// kernel's support (moving least squares, as in Marrone et al. 2011, eq. 12). The fit's value at
// the node follows from the moments sum_b V_b W_ab (1, dx, dz)(1, dx, dz)^T over liquid and images.
// Where the particles do not determine a linear fit (a splash), the weighted mean is used. A node
// without liquid in its support has no state. The sums are over the liquid and its images, which
// come before the solids in every list.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "sph/neighbours/instruction_sets.hpp"
#include "sph/neighbours/lanes.hpp"
#include "sph/neighbours/neighbour_sources.hpp"
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

  void add(Number weight, Number dx, Number dz) {
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

  void add(Number weight, Number dx, Number dz, double value) {
    f += weight * value;
    x += weight * dx * value;
    z += weight * dz * value;
  }
  // Returns the fit's value at the nodes.
  Number value(const NodeMoments<Number>& s) const {
    // a, b and c are the cofactors of the first row of the moments' matrix.
    const Number a = s.xx * s.zz - s.xz * s.xz, b = s.xz * s.z - s.x * s.zz,
                 c = s.x * s.xz - s.xx * s.z;
    const Number determinant = s.m * a + s.x * b + s.z * c;
    // With a full support the determinant is about 0.01 m^3 in units of the smoothing length.
    constexpr double least = 1e-3;
    const auto fitted = determinant > least * s.m * s.m * s.m;
    return (fitted ? f * a + x * b + z * c : f) / (fitted ? determinant : s.m);
  }
};

// The template depends on the kernel and not on the scheme, so that schemes share its builds.
template <class Kernel, double Source::*value>
struct SumAtNodesOfCluster {
  template <Vector Number>
  static void run(double smoothing_length, const Cluster* cluster, const Source* sources,
                  std::size_t first_solid_source, const SolidPlace* places, const TankWalls* walls,
                  NodeSum* nodes) {
    const double inverse_h = 1.0 / smoothing_length;
    for (std::size_t first = cluster->first; first < cluster->first + cluster->size;
         first += lanes_of<Number>) {
      const std::size_t count = std::min(lanes_of<Number>, cluster->first + cluster->size - first);
      Number node_x{}, node_z{};
      for (std::size_t i = 0; i < count; ++i) {
        node_x[i] = walls->left + places[first + i].node_x;
        node_z[i] = walls->bottom + places[first + i].node_z;
      }
      NodeMoments<Number> moments;
      NodeProjection<Number> field, u, w;
      for (std::size_t k = 0; k < cluster->source_count && cluster->sources[k] < first_solid_source;
           ++k) {
        const Source& b = sources[cluster->sources[k]];
        const Number dx = (b.x - node_x) * inverse_h, dz = (b.z - node_z) * inverse_h;
        const Number weight = b.weight * Kernel::shape(square_root(dx * dx + dz * dz));
        moments.add(weight, dx, dz);
        field.add(weight, dx, dz, b.*value);
        u.add(weight, dx, dz, b.velocity_x);
        w.add(weight, dx, dz, b.velocity_z);
      }
      const Number value_at = field.value(moments), u_at = u.value(moments),
                   w_at = w.value(moments);
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

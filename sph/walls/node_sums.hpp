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

struct NodeMoments {
  Lanes m{}, x{}, z{}, xx{}, xz{}, zz{};
};
struct NodeProjection {
  Lanes f{}, x{}, z{};

  void add(Lanes weight, Lanes dx, Lanes dz, double value) {
    f += weight * value;
    x += weight * dx * value;
    z += weight * dz * value;
  }
  // Returns the fit's value at the node of lane i.
  double value(const NodeMoments& s, std::size_t i) const {
    // a, b and c are the cofactors of the first row of the moments' matrix.
    const double a = s.xx[i] * s.zz[i] - s.xz[i] * s.xz[i], b = s.xz[i] * s.z[i] - s.x[i] * s.zz[i],
                 c = s.x[i] * s.xz[i] - s.xx[i] * s.z[i];
    const double determinant = s.m[i] * a + s.x[i] * b + s.z[i] * c;
    const double m = s.m[i];
    // With a full support the determinant is about 0.01 m^3 in units of the smoothing length.
    constexpr double least = 1e-3;
    if (determinant > least * m * m * m) return (f[i] * a + x[i] * b + z[i] * c) / determinant;
    return f[i] / m;
  }
};

// The template depends on the kernel and not on the scheme, so that schemes share its builds.
template <class Kernel, double Source::*value>
void sum_at_nodes_of_cluster(double smoothing_length, const Cluster* cluster, const Source* sources,
                             std::size_t first_solid_source, const SolidPlace* places,
                             const TankWalls* walls, NodeSum* nodes) {
  Lanes node_x{}, node_z{};
  for (std::size_t i = 0; i < cluster->size; ++i) {
    node_x[i] = walls->left + places[cluster->first + i].node_x;
    node_z[i] = walls->bottom + places[cluster->first + i].node_z;
  }
  const double inverse_h = 1.0 / smoothing_length;
  NodeMoments moments;
  NodeProjection field, u, w;
  for (std::size_t k = 0; k < cluster->source_count && cluster->sources[k] < first_solid_source;
       ++k) {
    const Source& b = sources[cluster->sources[k]];
    const Lanes dx = (b.x - node_x) * inverse_h, dz = (b.z - node_z) * inverse_h;
    const Lanes weight = b.weight * Kernel::shape(square_root(dx * dx + dz * dz));
    moments.m += weight;
    moments.x += weight * dx;
    moments.z += weight * dz;
    moments.xx += weight * dx * dx;
    moments.xz += weight * dx * dz;
    moments.zz += weight * dz * dz;
    field.add(weight, dx, dz, b.*value);
    u.add(weight, dx, dz, b.velocity_x);
    w.add(weight, dx, dz, b.velocity_z);
  }
  for (std::size_t i = 0; i < cluster->size; ++i) {
    NodeSum& node = nodes[cluster->first + i];
    node = {};
    node.found = moments.m[i] > 0;
    if (!node.found) continue;
    node.liquid = moments.m[i];
    node.value = field.value(moments, i);
    node.velocity_x = u.value(moments, i);
    node.velocity_z = w.value(moments, i);
  }
}

// Evaluates the velocity and the sources' field `value` at the nodes.
template <double Source::*value, class Scheme>
void sum_at_nodes(const Scheme& scheme, const NeighbourSources& neighbours,
                  const std::vector<SolidPlace>& places, const TankWalls& walls,
                  std::vector<NodeSum>& nodes, InstructionSet set) {
  neighbours.solid_clusters().for_each([&](const Cluster& cluster) {
    call<&sum_at_nodes_of_cluster<typename Scheme::Kernel, value>>(
        set, scheme.setting.smoothing_length(), &cluster, neighbours.sources(),
        neighbours.first_solid_source(), places.data(), &walls, nodes.data());
  });
}

}  // namespace slosh::sph

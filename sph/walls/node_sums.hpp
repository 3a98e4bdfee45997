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

struct Nodes {
  Array<double> x, z;  // in the tank [m]
  // What the sums find: the kernel sum of the liquid, without the kernel's normalisation and 1/h^2,
  // the liquid's velocity, and one of its fields. Without liquid all are 0.
  Array<double> liquid, velocity_x, velocity_z, value;

  std::size_t size() const { return x.size(); }
  bool found(std::size_t i) const { return liquid[i] > 0; }

  // The places must have their final order.
  void place(const std::vector<SolidPlace>& places) {
    for_each_named_field(
        [&](const char*, Array<double>& field) { field.assign(places.size(), 0.0); });
    for (std::size_t i = 0; i < places.size(); ++i) {
      x[i] = places[i].node_x;
      z[i] = places[i].node_z;
    }
  }
  template <class Visit>
  void for_each_named_field(const Visit& visit) {
    for (auto* field : {&x, &z, &liquid, &velocity_x, &velocity_z, &value}) visit("nodes", *field);
  }
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
    // Without liquid the quotient is that of 0 by 1.
    const Number divisor = fitted ? determinant : s.m;
    return (fitted ? f * a + x * b + z * c : f) / (s.m > Number{} ? divisor : 1.0 - Number{});
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
                  std::size_t first_solid_source, const TankWalls* walls, Nodes* nodes) {
    const std::size_t sources_of_liquid = liquid_sources(*cluster, first_solid_source);
    for (std::size_t i = cluster->first; i < cluster->first + cluster->size;
         i += lanes_of<Number>) {
      const std::size_t count = cluster->first + cluster->size - i;
      Number liquid{}, value_at{}, u_at{}, w_at{};
      if (sources_of_liquid > 0) {
        const Number node_x = walls->left + load<Number>(&nodes->x[i]),
                     node_z = walls->bottom + load<Number>(&nodes->z[i]);
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
        liquid = moments.m;
        value_at = field.value(moments, smoothing_length);
        u_at = u.value(moments, smoothing_length);
        w_at = w.value(moments, smoothing_length);
      }
      store(&nodes->liquid[i], liquid, count);
      store(&nodes->value[i], value_at, count);
      store(&nodes->velocity_x[i], u_at, count);
      store(&nodes->velocity_z[i], w_at, count);
    }
  }
};

// Evaluates the velocity and the sources' field `value` at the nodes.
template <double Source::*value, class Scheme>
void sum_at_nodes(const Scheme& scheme, const NeighbourSources& neighbours, const TankWalls& walls,
                  Nodes& nodes, InstructionSet set) {
  neighbours.solid_clusters().for_each([&](const Cluster& cluster) {
    call_in_registers<SumAtNodesOfCluster<typename Scheme::Kernel, value>>(
        set, scheme.setting.smoothing_length(), &cluster, neighbours.sources(),
        neighbours.first_solid_source(), &walls, &nodes);
  });
}

}  // namespace slosh::sph

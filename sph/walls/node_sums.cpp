#include "sph/walls/node_sums.hpp"

#include <algorithm>
#include <cstdint>

#include "sph/neighbours/lanes.hpp"
#include "sph/neighbours/two_sources.hpp"
#include "sph/terms/kernels.hpp"

namespace slosh::sph {
namespace {

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
std::size_t liquid_sources(const Cluster& cluster, std::size_t first_solid_source) {
  const std::uint32_t* end = cluster.sources + cluster.source_count;
  return static_cast<std::size_t>(std::lower_bound(cluster.sources, end, first_solid_source) -
                                  cluster.sources);
}

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

}  // namespace

template <class Kernel>
void sum_at_nodes(NodeValue value, double smoothing_length, const NeighbourSources& neighbours,
                  const TankWalls& walls, Nodes& nodes, InstructionSet set) {
  const auto sum = [&]<class Loop>(Loop) {
    neighbours.solid_clusters().for_each([&](const Cluster& cluster) {
      call_in_registers<Loop>(set, smoothing_length, &cluster, neighbours.sources(),
                              neighbours.first_solid_source(), &walls, &nodes);
    });
  };
  if (value == NodeValue::strength)
    sum(SumAtNodesOfCluster<Kernel, &Source::strength>{});
  else
    sum(SumAtNodesOfCluster<Kernel, &Source::density>{});
}

#define SLOSH_COMPILE(KERNEL)                                                                      \
  template void sum_at_nodes<KERNEL>(NodeValue, double, const NeighbourSources&, const TankWalls&, \
                                     Nodes&, InstructionSet)
SLOSH_COMPILE(CubicSpline);
SLOSH_COMPILE(QuinticSpline);
SLOSH_COMPILE(WendlandC2);
SLOSH_COMPILE(WendlandC4);
SLOSH_COMPILE(WendlandC6);
SLOSH_COMPILE(KaiserBessel);

}  // namespace slosh::sph

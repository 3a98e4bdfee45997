#include "sph/walls/node_sums.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sph/scheme.hpp"
#include "sph/schemes.hpp"
#include "sph/tests/disordered_liquid.hpp"
#include "sph/walls/solids.hpp"

namespace slosh::sph::node_sums_test {
namespace {

constexpr double support = 0.03;  // of the recommended scheme at this spacing

double linear_field(double x, double z) { return 3 + 40 * x - 70 * z; }

class NodeSums : public testing::Test {
 protected:
  // The sums at places of the tank at rest over the particles, without images or solids.
  Nodes sums(Particles particles, std::vector<SolidPlace> places) {
    NeighbourSources neighbours(tank_at_rest, small_spacing, support);
    neighbours.add_solids(places, {});
    EXPECT_TRUE(neighbours.rebuild(particles, tank_at_rest, 0, false));
    neighbours.refresh_for_momentum(scheme_, particles, tank_at_rest);
    // The evaluated field does not enter the weights.
    Nodes found;
    for (const InstructionSet set :
         {InstructionSet::plain, InstructionSet::avx2, InstructionSet::avx512}) {
      if (!has(set)) continue;
      found.place(places);
      sum_at_nodes<WithGhostWalls::Kernel>(NodeValue::density, scheme_.setting.smoothing_length(),
                                           neighbours, tank_at_rest, found, set);
      for (std::size_t i = 0; i < places.size(); ++i) check(found, i);
    }
    return found;
  }

  void check(const Nodes& nodes, std::size_t i) {
    if (!expect_linear_) return;
    ASSERT_TRUE(nodes.found(i));
    const double expected = linear_field(nodes.x[i], nodes.z[i]);
    EXPECT_NEAR(nodes.value[i], expected, 1e-11);
    EXPECT_NEAR(nodes.velocity_x[i], 0.1 * expected, 1e-12);
    EXPECT_NEAR(nodes.velocity_z[i], -0.2 * expected, 1e-12);
  }

  // Density and velocity linear in space.
  static Particles with_linear_fields(Particles p) {
    for (std::size_t i = 0; i < p.size(); ++i) {
      p.density[i] = linear_field(p.x[i], p.z[i]);
      p.velocity_x[i] = 0.1 * p.density[i];
      p.velocity_z[i] = -0.2 * p.density[i];
      p.mass[i] = 1e-4 * p.density[i];
    }
    return p;
  }

  static SolidPlace node_at(double x, double z) { return {-0.005, z, x, z, {true, false}}; }

  const Scheme<WithGhostWalls> scheme_{small_scene()};
  bool expect_linear_ = false;
};

TEST_F(NodeSums, ReproduceALinearFieldInFullAndHalfSupports) {
  expect_linear_ = true;
  std::vector<SolidPlace> places;
  for (double along : {0.0, 0.001, 0.013, 0.05, 0.08, 0.1, 0.147, 0.16}) {
    places.push_back(node_at(along, 0.08));
    places.push_back(node_at(0.1, along));
  }
  sums(with_linear_fields(full_tank(tank_at_rest)), places);
}

// Two particles carry no plane: the weights are those of the kernel alone.
TEST_F(NodeSums, AreThePlainMeanInASplash) {
  DisorderedLiquid splash(tank_at_rest);
  splash.add(0.09, 0.08, small_spacing);
  splash.add(0.112, 0.08, small_spacing);
  Particles p = splash.particles;
  p.density = {900, 1100};
  p.velocity_x = {1, 3};
  p.velocity_z = {-2, 0};
  p.mass = {0.09, 0.11};  // equal volumes
  const Nodes half = sums(p, {node_at(0.101, 0.08)});
  ASSERT_TRUE(half.found(0));
  EXPECT_NEAR(half.value[0], 1000, 1e-9);
  EXPECT_NEAR(half.velocity_x[0], 2, 1e-12);
  EXPECT_NEAR(half.velocity_z[0], -1, 1e-12);
  const double near = Recommended::Kernel::shape(0.004 / 0.015),
               far = Recommended::Kernel::shape(0.018 / 0.015);
  const Nodes nearer = sums(p, {node_at(0.094, 0.08)});
  EXPECT_NEAR(nearer.value[0], (near * 900 + far * 1100) / (near + far), 1e-9);
}

TEST_F(NodeSums, FindNothingWhereTheSupportIsEmpty) {
  DisorderedLiquid drop(tank_at_rest);
  drop.add(0.1, 0.08, small_spacing);
  const Nodes found =
      sums(drop.particles, {node_at(0.1, 0.1101), node_at(0.02, 0.08), node_at(0.1, 0.1095)});
  for (std::size_t i = 0; i < found.size(); ++i) {
    const bool reached = found.z[i] == 0.1095;
    EXPECT_EQ(found.found(i), reached);
    EXPECT_EQ(found.value[i] != 0, reached);
  }
}

}  // namespace
}  // namespace slosh::sph::node_sums_test

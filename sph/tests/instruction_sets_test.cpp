// The same run with every instruction set of this processor. The order of the sums is the same in
// all, but wider sets fuse multiplications with additions: the last bits differ, and the particles'
// paths spread them.
#include "sph/neighbours/instruction_sets.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sph/liquid.hpp"
#include "sph/scheme.hpp"
#include "sph/schemes.hpp"
#include "sph/start/initial_lattice.hpp"
#include "sph/tests/surging_scene.hpp"

namespace slosh::sph::instruction_sets_test {
namespace {

constexpr double spacing = 0.025;

template <class Choice>
Particles after_a_surge(InstructionSet set) {
  const Scene scene = surging_scene(spacing, 0.2);
  const Scheme<Choice> scheme(scene);
  Liquid liquid(scene, method_of(scheme), initial_lattice(scene, [&](double pressure) {
                  return scheme.state.density(pressure);
                }));
  liquid.use(set);
  typename Choice::Integrator integrator;
  const double dt = 0.4 * scheme.setting.smoothing_length() / scheme.setting.speed_of_sound;
  while (liquid.time < scene.duration) {
    integrator.advance(liquid, dt);
    liquid.time += dt;
  }
  return liquid.particles;
}

template <class Choice>
class InstructionSets : public testing::Test {};
using Choices = testing::Types<Recommended, WithWendlandC2, Li2010, DeltaSph>;
TYPED_TEST_SUITE(InstructionSets, Choices);

// Particles come out in the same order: where they stand decides it, and they differ by far less
// than a cell.
TYPED_TEST(InstructionSets, MoveTheParticlesAlikeToABillionthOfTheirSpacing) {
  if (widest_instruction_set() == InstructionSet::plain)
    GTEST_SKIP() << "this build, or this processor, has the plain instructions alone";
  const Particles plain = after_a_surge<TypeParam>(InstructionSet::plain);
  for (const InstructionSet set : {InstructionSet::avx2, InstructionSet::avx512}) {
    if (!has(set)) continue;
    const Particles wide = after_a_surge<TypeParam>(set);
    double farthest = 0;
    for (std::size_t i = 0; i < plain.size(); ++i) {
      const double distance = std::hypot(wide.x[i] - plain.x[i], wide.z[i] - plain.z[i]);
      farthest = std::isnan(distance) ? distance : std::max(farthest, distance);
    }
    EXPECT_LE(farthest, 1e-9 * spacing) << instruction_set_name(set);
  }
}

struct Roots {
  template <Vector Number>
  static void run(const double* numbers, double* roots, double* reciprocals) {
    const Number a = load<Number>(numbers);
    store(roots, inverse_square_root(a), lanes_of<Number>);
    store(reciprocals, reciprocal(a), lanes_of<Number>);
  }
};

TEST(InstructionSetsAll, TakeRootsAndReciprocalsToTheLastPlaces) {
  for (const InstructionSet set : instruction_sets) {
    if (!has(set)) continue;
    for (double first = 1e-60; first < 1e60; first *= 1.0371) {
      double numbers[lane_count], roots[lane_count], reciprocals[lane_count];
      for (std::size_t lane = 0; lane < lane_count; ++lane)
        numbers[lane] = first * (1 + 0.31 * static_cast<double>(lane));
      call_in_registers<Roots>(set, &numbers[0], &roots[0], &reciprocals[0]);
      for (std::size_t lane = 0; lane < 2; ++lane) {  // all sets have two
        EXPECT_NEAR(roots[lane] * std::sqrt(numbers[lane]), 1, 1e-15) << numbers[lane];
        EXPECT_NEAR(reciprocals[lane] * numbers[lane], 1, 1e-15) << numbers[lane];
      }
    }
  }
}

}  // namespace
}  // namespace slosh::sph::instruction_sets_test

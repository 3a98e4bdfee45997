// What every scheme owes to physics, in runs of some hundred steps.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include "sph/integrators.hpp"
#include "sph/liquid.hpp"
#include "sph/neighbours/instruction_sets.hpp"
#include "sph/scheme.hpp"
#include "sph/schemes.hpp"
#include "sph/start/initial_lattice.hpp"
#include "sph/tests/named_schemes.hpp"
#include "sph/tests/surging_scene.hpp"

namespace slosh::sph::scheme_runs_test {
namespace {

void expect_same_bits(const History& a, const History& b) {
  EXPECT_EQ(a.time, b.time);
  EXPECT_EQ(a.value, b.value);
}

RunOutput run_with_threads(int threads, const std::string& name, Scene scene) {
  scene.threads = threads;
  return run_named(name, scene);
}

class RunOfEveryScheme : public EachNamedScheme {};
INSTANTIATE_TEST_SUITE_P(Named, RunOfEveryScheme, testing::ValuesIn(schemes_and_variants()),
                         [](const auto& scheme) { return scheme.param; });

TEST_P(RunOfEveryScheme, GivesTheSameBitsWithOneAndTwoThreads) {
  // A few steps: threads that wait for one another on a busy machine take many times as long.
  Scene scene = surging_scene(0.05, 0.005);
  scene.sample_interval = 0.005;
  const RunOutput one = run_with_threads(1, GetParam(), scene);
  const RunOutput two = run_with_threads(2, GetParam(), scene);
  for (const Gauge& gauge : scene.gauges)
    expect_same_bits(one.elevation.at(gauge.name), two.elevation.at(gauge.name));
  expect_same_bits(one.force_x, two.force_x);
  expect_same_bits(one.kinetic_energy, two.kinetic_energy);
  expect_same_bits(one.potential_energy, two.potential_energy);
}

TEST_P(RunOfEveryScheme, AnswersTheMirroredMotionWithTheMirroredWave) {
  Scene right = surging_scene(0.025, 0.2), left = surging_scene(0.025, 0.2, -0.02);
  // A projection is the mirrored one's image to its solver's tolerance alone.
  right.initial_state = left.initial_state = InitialState::lattice;
  const RunOutput ahead = run_it(right), back = run_it(left);
  EXPECT_GT(largest(ahead.elevation.at("right").value), 1e-3);
  // Round-off grows along the particles' paths; the wave is of millimetres.
  EXPECT_LE(largest_difference(ahead.elevation.at("right").value, back.elevation.at("left").value),
            1e-9);
  EXPECT_LE(largest_difference(ahead.elevation.at("left").value, back.elevation.at("right").value),
            1e-9);
}

TEST_P(RunOfEveryScheme, FollowsGravity) {
  Scene scene = surging_scene(0.05, 0.8);
  const auto earth = run_it(scene).elevation.at("right").value;
  scene.gravity = 9.0;
  const auto lighter = run_it(scene).elevation.at("right").value;
  EXPECT_GT(largest_difference(earth, lighter), 0.03 * largest(earth));
}

// Momentum from snapshots, with every particle of the same mass: their masses differ by the
// hydrostatic compression, 1 % over the depth. One step per sample.
TEST_P(RunOfEveryScheme, GivesTheForceThatChangesTheLiquidsMomentum) {
  Scene scene = surging_scene(0.025, 0.2);
  const bool short_steps = GetParam() == "verlet" || GetParam().starts_with("zhao2021");
  scene.sample_interval = scene.snapshot_interval = short_steps ? 2.5e-4 : 5e-4;
  std::vector<double> momentum;
  scene.record_snapshot = [&](const Snapshot& s) {
    const double mass = 1000 * 0.35 / static_cast<double>(s.x.size());
    momentum.push_back(mass * std::accumulate(s.velocity_x.begin(), s.velocity_x.end(), 0.0));
  };
  const RunOutput output = run_it(scene);
  const std::vector<double>& force = output.force_x.value;
  ASSERT_EQ(output.steps, static_cast<double>(force.size() - 1));
  ASSERT_EQ(momentum.size(), force.size());
  // The leapfrog's velocities are of half a step before the sample.
  const bool staggered =
      std::count(output.active_terms.begin(), output.active_terms.end(), StaggeredLeapfrog::name);
  double error2 = 0, force2 = 0;
  for (std::size_t i = 1; i + 1 < force.size(); ++i) {
    const double rate = staggered
                            ? (momentum[i + 1] - momentum[i]) / scene.sample_interval
                            : (momentum[i + 1] - momentum[i - 1]) / (2 * scene.sample_interval);
    error2 += std::pow(force[i] + rate, 2);
    force2 += std::pow(force[i], 2);
  }
  EXPECT_LE(std::sqrt(error2 / force2), 0.02);
}

class EveryVariant : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Named, EveryVariant, testing::ValuesIn(variant_names()),
                         [](const auto& variant) { return variant.param; });

// The tank's largest kinetic energy, of its 0.03 m/s, is 0.15 J/m, and that of the wave not far
// from it.
TEST_P(EveryVariant, DiffersFromTheRecommendedSchemeButGivesMuchTheSameSurge) {
  Scene scene = surging_scene(0.025, 0.2);
  scene.kinematic_viscosity = 1e-6;
  const RunOutput recommended = run("recommended", scene, {});
  const RunOutput variant = run_named(GetParam(), scene);
  EXPECT_GT(largest_difference(variant.elevation.at("right").value,
                               recommended.elevation.at("right").value),
            1e-8);
  const std::vector<double>&kinetic = variant.kinetic_energy.value,
        &potential = variant.potential_energy.value;
  for (std::size_t i = 0; i < kinetic.size(); ++i) {
    EXPECT_LT(kinetic[i], 0.3);
    EXPECT_GT(potential[i], -0.3);
    EXPECT_LT(potential[i], 0.3);
  }
  EXPECT_NE(variant.active_terms, recommended.active_terms);
}

// Nothing in the flow depends on how fast the tank and the liquid travel together.
TEST(Recommended, StaysStillInStillAndInCarriedTanks) {
  for (double speed : {0.0, 0.5}) {
    const double spacing = 0.025;
    const RunOutput output = run("recommended", carried_scene(spacing, 2.0, speed), {});
    EXPECT_LE(largest(output.elevation.at("left").value), 0.01 * spacing) << speed;
    EXPECT_LE(largest(output.elevation.at("right").value), 0.01 * spacing) << speed;
    const double carried = 0.5 * 1000 * 0.35 * speed * speed;  // but for the compression, 0.5 %
    EXPECT_NEAR(output.kinetic_energy.value.back(), carried, 0.01 * carried + 1e-4) << speed;
    EXPECT_LE(largest(output.potential_energy.value), 0.1) << speed;
    EXPECT_LE(std::abs(output.force_x.value.back()), 1e-2) << speed;
  }
}

// A spacing at which the fixed step's Courant number, 0.645, is just below the limit.
TEST(FixedStep, IsStableBelowTheGuardsLimit) {
  Scene scene = surging_scene(0.2 / 38, 0.6, 0.002);
  scene.tank_length = scene.tank_height = 0.2;
  scene.fill_depth = 20 * scene.particle_spacing;
  scene.gauges.clear();
  const double courant = 5e-4 * 10 *
                         (std::sqrt(scene.gravity * scene.fill_depth) + scene.velocity(0)) /
                         (1.5 * scene.particle_spacing);
  ASSERT_GT(courant, 0.63);
  const RunOutput output = run("li2010", scene, {});
  // The energy stays of the order of the tank's own, 0.09 mJ/m; an unstable step makes 10 mJ/m.
  for (double energy : output.kinetic_energy.value) EXPECT_LT(energy, 1e-3);
}

// The same run with every instruction set of this processor. The order of the sums is the same in
// all, but wider sets fuse multiplications with additions: the last bits differ, and the particles'
// paths spread them.

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
}  // namespace slosh::sph::scheme_runs_test

// What every scheme owes to physics, in runs of some hundred steps.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include "sph/integrators.hpp"
#include "sph/tests/named_schemes.hpp"
#include "sph/tests/surging_scene.hpp"

namespace slosh::sph::scheme_runs_test {
namespace {

double largest(const std::vector<double>& values) {
  double result = 0;
  for (double value : values)
    result = std::isnan(value) ? value : std::max(result, std::abs(value));
  return result;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  EXPECT_EQ(a.size(), b.size());
  double difference = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    difference = std::max(difference, std::abs(a[i] - b[i]));
  return difference;
}

class RunOfEveryScheme : public EachNamedScheme {};
INSTANTIATE_TEST_SUITE_P(Named, RunOfEveryScheme, testing::ValuesIn(schemes_and_variants()),
                         [](const auto& scheme) { return scheme.param; });

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

}  // namespace
}  // namespace slosh::sph::scheme_runs_test

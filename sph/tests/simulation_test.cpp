#include "sph/simulation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "sph/integrators.hpp"
#include "sph/tests/surging_scene.hpp"

namespace slosh::sph::simulation_test {
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

void expect_same_bits(const History& a, const History& b) {
  EXPECT_EQ(a.time, b.time);
  EXPECT_EQ(a.value, b.value);
}

// A scheme by its name, or a variant of the recommended one by its own.
RunOutput run_named(const std::string& name, Scene scene) {
  const std::vector<std::string> schemes = scheme_names();
  if (std::find(schemes.begin(), schemes.end(), name) != schemes.end()) return run(name, scene, {});
  scene.variant = name;
  return run("recommended", scene, {});
}

std::vector<std::string> schemes_and_variants() {
  std::vector<std::string> names = scheme_names();
  for (const std::string& variant : variant_names()) names.push_back(variant);
  return names;
}

RunOutput run_with_threads(int threads, const std::string& name, Scene scene) {
  scene.threads = threads;
  return run_named(name, scene);
}

class EveryScheme : public testing::TestWithParam<std::string> {
 protected:
  RunOutput run_it(const Scene& scene) const { return run_named(GetParam(), scene); }
};
INSTANTIATE_TEST_SUITE_P(Named, EveryScheme, testing::ValuesIn(schemes_and_variants()),
                         [](const auto& scheme) { return scheme.param; });

TEST_P(EveryScheme, GivesTheSameBitsWithOneAndTwoThreads) {
  // A few steps: threads that wait for one another on a busy machine take many times as long.
  Scene scene = surging_scene(0.025, 0.005);
  scene.sample_interval = 0.005;
  const RunOutput one = run_with_threads(1, GetParam(), scene);
  const RunOutput two = run_with_threads(2, GetParam(), scene);
  for (const Gauge& gauge : scene.gauges)
    expect_same_bits(one.elevation.at(gauge.name), two.elevation.at(gauge.name));
  expect_same_bits(one.force_x, two.force_x);
  expect_same_bits(one.kinetic_energy, two.kinetic_energy);
  expect_same_bits(one.potential_energy, two.potential_energy);
}

TEST_P(EveryScheme, RecordsWhatTheSceneAsksFor) {
  Scene scene = surging_scene(0.05, 0.1);
  scene.snapshot_interval = 0.05;
  std::vector<double> snapshots;
  scene.record_snapshot = [&](const Snapshot& snapshot) {
    snapshots.push_back(snapshot.time);
    EXPECT_EQ(snapshot.x.size(), 140);
    EXPECT_EQ(snapshot.pressure.size(), 140);
  };
  const RunOutput output = run_it(scene);
  const History& right = output.elevation.at("right");
  ASSERT_EQ(right.time.size(), 11);
  EXPECT_EQ(right.time[3], 3 * 0.01);
  EXPECT_EQ(output.kinetic_energy.time, right.time);
  EXPECT_EQ(output.force_x.time, right.time);
  EXPECT_EQ(output.particles, 140);
  EXPECT_GE(output.steps, 10);
  EXPECT_FALSE(output.active_terms.empty());
  EXPECT_GT(output.diagnostics.at("smallest_time_step_s"), 0);
  EXPECT_EQ(snapshots, (std::vector<double>{0, 0.05, 0.1}));
}

TEST_P(EveryScheme, AnswersTheMirroredMotionWithTheMirroredWave) {
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

// With the scene's density at the surface the liquid was 0.5 % too heavy. What is left is of second
// order in the compression.
TEST_P(EveryScheme, GivesTheTankTheMassOfItsLiquid) {
  Scene scene = still_scene(0.05, 0);
  double mass = 0;
  scene.snapshot_interval = scene.sample_interval;
  scene.record_snapshot = [&](const Snapshot& snapshot) {
    for (const double density : snapshot.density) mass += 0.35 / 140 * density;
  };
  run_it(scene);
  EXPECT_NEAR(mass, 350, 2e-4 * 350);
}

TEST_P(EveryScheme, FollowsGravity) {
  Scene scene = surging_scene(0.05, 0.8);
  const auto earth = run_it(scene).elevation.at("right").value;
  scene.gravity = 9.0;
  const auto lighter = run_it(scene).elevation.at("right").value;
  EXPECT_GT(largest_difference(earth, lighter), 0.03 * largest(earth));
}

// Momentum from snapshots, with every particle of the same mass: their masses differ by the
// hydrostatic compression, 1 % over the depth. One step per sample.
TEST_P(EveryScheme, GivesTheForceThatChangesTheLiquidsMomentum) {
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

TEST(Simulation, RefusesASchemeThatItDoesNotHave) {
  try {
    run("recomended", still_scene(0.05, 0.1), {});
    FAIL() << "an unknown scheme was let pass";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("recomended"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("li2010"), std::string::npos);
  }
}

TEST(Simulation, RefusesSnapshotsBetweenSamples) {
  for (const double interval : {0.015, 0.005, -0.01, double{NAN}, double{INFINITY}}) {
    Scene scene = surging_scene(0.05, 0.02);
    scene.snapshot_interval = interval;
    EXPECT_THROW(run("recommended", scene, {}), std::invalid_argument) << interval;
  }
}

TEST(Simulation, RefusesATankTooNarrowForTheKernel) {
  Scene scene = still_scene(0.025, 0.1);
  scene.tank_length = 0.1;
  scene.gauges.clear();
  EXPECT_THROW(run("recommended", scene, {}), std::invalid_argument);
}

TEST(Simulation, RefusesTwoSpacingsWhereTheSchemeTakesOne) {
  Scene scene = still_scene(0.02, 0.1);
  scene.surface_particle_spacing = 0.01;
  EXPECT_THROW(run("recommended", scene, {}), std::invalid_argument);
  EXPECT_THROW(run("delta_sph", scene, {}), std::invalid_argument);
}

TEST(Simulation, RunsLisSchemeWithTwoSpacings) {
  Scene scene = surging_scene(0.04, 0.1);
  scene.fill_depth = 0.36;
  scene.surface_particle_spacing = 0.02;
  const RunOutput output = run("li2010", scene, {});
  EXPECT_EQ(output.particles, 4 * 25 + 10 * 50);
  EXPECT_EQ(output.active_terms[1], "smoothing length averaged over each pair");
}

TEST(Simulation, RefusesALatticeThatDoesNotFitTheTank) {
  EXPECT_THROW(run("recommended", still_scene(0.08, 0.1), {}), std::invalid_argument);
}

}  // namespace
}  // namespace slosh::sph::simulation_test

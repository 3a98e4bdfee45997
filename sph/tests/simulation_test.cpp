#include "sph/simulation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "sph/tests/named_schemes.hpp"
#include "sph/tests/surging_scene.hpp"
#include "verification/tests/messages.hpp"

namespace slosh::sph::simulation_test {
namespace {

void expect_same_bits(const History& a, const History& b) {
  EXPECT_EQ(a.time, b.time);
  EXPECT_EQ(a.value, b.value);
}

RunOutput run_with_threads(int threads, const std::string& name, Scene scene) {
  scene.threads = threads;
  return run_named(name, scene);
}

class EveryScheme : public EachNamedScheme {};
INSTANTIATE_TEST_SUITE_P(Named, EveryScheme, testing::ValuesIn(schemes_and_variants()),
                         [](const auto& scheme) { return scheme.param; });

TEST_P(EveryScheme, GivesTheSameBitsWithOneAndTwoThreads) {
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

TEST_P(EveryScheme, RecordsWhatTheSceneAsksFor) {
  Scene scene = surging_scene(0.05, 0.03);
  scene.snapshot_interval = 0.01;
  std::vector<double> snapshots;
  scene.record_snapshot = [&](const Snapshot& snapshot) {
    snapshots.push_back(snapshot.time);
    EXPECT_EQ(snapshot.x.size(), 140);
    EXPECT_EQ(snapshot.pressure.size(), 140);
  };
  const RunOutput output = run_it(scene);
  const History& right = output.elevation.at("right");
  ASSERT_EQ(right.time.size(), 4);
  EXPECT_EQ(right.time[3], 3 * 0.01);
  EXPECT_EQ(output.kinetic_energy.time, right.time);
  EXPECT_EQ(output.force_x.time, right.time);
  EXPECT_EQ(output.particles, 140);
  EXPECT_GE(output.steps, 3);
  EXPECT_FALSE(output.active_terms.empty());
  EXPECT_GT(output.diagnostics.at("smallest_time_step_s"), 0);
  EXPECT_EQ(snapshots, (std::vector<double>{0, 0.01, 0.02, 0.03}));
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

TEST(Simulation, RefusesASchemeThatItDoesNotHave) {
  const std::string message =
      message_of<std::invalid_argument>([&] { run("recomended", still_scene(0.05, 0.1), {}); });
  EXPECT_TRUE(slosh::holds(message, "recomended"));
  EXPECT_TRUE(slosh::holds(message, "li2010"));
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
  Scene scene = surging_scene(0.04, 0.01);
  scene.fill_depth = 0.36;
  scene.surface_particle_spacing = 0.02;
  const RunOutput output = run("li2010", scene, {});
  EXPECT_EQ(output.particles, 4 * 25 + 10 * 50);
  EXPECT_EQ(output.active_terms[1], "smoothing length averaged over each pair");
}

TEST(Simulation, RefusesALatticeThatDoesNotFitTheTank) {
  EXPECT_THROW(run("recommended", still_scene(0.08, 0.1), {}), std::invalid_argument);
}

TEST(Simulation, RecordsAFrontOfDamsAlone) {
  EXPECT_TRUE(run("recommended", still_scene(0.025, 0.02), {}).front_position.value.empty());
}

// A wall of mirror particles or of solids: without solids of any kind there is no obstacle.
TEST(Simulation, TakesObstaclesWhereTheSchemeHasSolids) {
  const Scene scene = with_obstacle(still_scene(0.025, 0.02), {0.4, 0.6, 0, 0.2});
  EXPECT_TRUE(slosh::holds(message_of<std::invalid_argument>([&] { run("li2010", scene, {}); }),
                           "obstacle: expected none"));
  for (const char* scheme : {"recommended", "ghost_walls", "dynamic_walls", "delta_sph"})
    EXPECT_EQ(run_named(scheme, scene).particles, 40 * 14 - 8 * 8) << scheme;
}

TEST(Simulation, RefusesAnObstacleThatIsTooThin) {
  EXPECT_THROW(run("recommended", with_obstacle(still_scene(0.025, 0.02), {0.4, 0.42, 0, 0.2}), {}),
               std::invalid_argument);
}

}  // namespace
}  // namespace slosh::sph::simulation_test

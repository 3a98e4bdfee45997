#include "sph/simulation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <string>

#include "sph/held_arrays.hpp"
#include "sph/neighbours/particles.hpp"
#include "sph/tests/named_schemes.hpp"
#include "sph/tests/surging_scene.hpp"
#include "verification/tests/messages.hpp"

namespace slosh::sph::simulation_test {
namespace {

class EveryScheme : public EachNamedScheme {};
INSTANTIATE_TEST_SUITE_P(Named, EveryScheme, testing::ValuesIn(schemes_and_variants()),
                         [](const auto& scheme) { return scheme.param; });

// With the scene's density at the surface the liquid was 0.5 % too heavy. What is left is of second
// order in the compression.
TEST_P(EveryScheme, RecordsWhatTheSceneAsksForOfTheMassOfItsLiquid) {
  Scene scene = surging_scene(0.05, 0.03);
  scene.snapshot_interval = 0.01;
  scene.loaded_walls = four_walls;
  double mass = 0;
  std::vector<double> snapshots;
  scene.record_snapshot = [&](const Snapshot& snapshot) {
    snapshots.push_back(snapshot.time);
    EXPECT_EQ(snapshot.x.size(), 140);
    EXPECT_EQ(snapshot.pressure.size(), 140);
    if (snapshot.time == 0)
      for (const double density : snapshot.density) mass += 0.35 / 140 * density;
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
  EXPECT_NEAR(mass, 350, 2e-4 * 350);
  expect_walls_to_add_up(output);
}

TEST(Simulation, RefusesASchemeThatItDoesNotHave) {
  const std::string message =
      message_of<std::invalid_argument>([&] { run("recomended", still_scene(0.05, 0.1), {}); });
  EXPECT_TRUE(slosh::holds(message, "recomended"));
  EXPECT_TRUE(slosh::holds(message, "li2010"));
}

struct Impossible {
  const char* what;
  double spacing;
  void (*change)(Scene&);
  const char* scheme = "recommended";
};

TEST(Simulation, RefusesASceneThatCannotBe) {
  const Impossible scenes[] = {
      {"a tank too narrow for the kernel", 0.025,
       [](Scene& s) { s.tank_length = 0.1, s.gauges.clear(); }},
      {"two spacings", 0.02, [](Scene& s) { s.surface_particle_spacing = 0.01; }},
      {"two spacings", 0.02, [](Scene& s) { s.surface_particle_spacing = 0.01; }, "delta_sph"},
      {"a lattice that does not fit the tank", 0.08, [](Scene&) {}},
      {"too thin an obstacle", 0.025,
       [](Scene& s) {
         s.obstacles = {{0.4, 0.42, 0, 0.2}};
       }},
      {"a probe below the tank", 0.05,
       [](Scene& s) {
         s.probes = {{"low", 0.5, -0.1}};
       }},
      {"a probe beside the tank", 0.05,
       [](Scene& s) {
         s.probes = {{"far", 1.1, 0.1}};
       }},
      {"a probe nowhere", 0.05,
       [](Scene& s) {
         s.probes = {{"none", std::nan(""), 0.1}};
       }},
      {"rows that would not come to rest", 0.05, [](Scene& s) { s.start_rotation = 0.35; }},
      {"turned rows and an obstacle", 0.05,
       [](Scene& s) {
         s.start_rotation = 0.35, s.initial_state = InitialState::settled;
         s.obstacles = {{0.4, 0.6, 0, 0.1}};
       }},
      {"a projection of walls with a density of their own", 0.025,
       [](Scene& s) {
         s = surging_scene(0.025, 0.1);
         s.initial_state = InitialState::projected, s.variant = "dynamic_walls";
       }},
      {"a wave that would run while the liquid settles", 0.025,
       [](Scene& s) {
         s.initial_wave = InitialWave{1, 0.02}, s.initial_state = InitialState::settled;
       }},
      {"too much disorder", 0.025, [](Scene& s) { s.start_disorder = 0.3; }},
  };
  for (const Impossible& one : scenes) {
    Scene scene = still_scene(one.spacing, 0.1);
    one.change(scene);
    EXPECT_THROW(run(one.scheme, scene, {}), std::invalid_argument) << one.what;
  }
  for (double Scene::*interval : {&Scene::snapshot_interval, &Scene::state_interval})
    for (const double between_samples : {0.015, 0.005, -0.01, double{NAN}, double{INFINITY}}) {
      Scene scene = surging_scene(0.05, 0.02);
      scene.initial_state = InitialState::lattice;
      scene.*interval = between_samples;
      EXPECT_THROW(run("recommended", scene, {}), std::invalid_argument) << between_samples;
    }
}

TEST(Simulation, RunsLisSchemeWithTwoSpacings) {
  Scene scene = surging_scene(0.04, 0.001);
  scene.sample_interval = scene.duration;
  scene.fill_depth = 0.36;
  scene.surface_particle_spacing = 0.02;
  const RunOutput output = run("li2010", scene, {});
  EXPECT_EQ(output.particles, 4 * 25 + 10 * 50);
  EXPECT_EQ(output.active_terms[1], "smoothing length averaged over each pair");
}

TEST(Simulation, RecordsAFrontOfDamsAlone) {
  EXPECT_TRUE(run("recommended", still_scene(0.05, 0.01), {}).front_position.value.empty());
}

// A wall of mirror particles or of solids: without solids of any kind there is no obstacle.
TEST(Simulation, TakesObstaclesWhereTheSchemeHasSolids) {
  const Scene scene = with_obstacle(still_scene(0.05, 0.01), {0.4, 0.6, 0, 0.2});
  EXPECT_TRUE(slosh::holds(message_of<std::invalid_argument>([&] { run("li2010", scene, {}); }),
                           "obstacle: expected none"));
  for (const char* scheme : {"recommended", "ghost_walls", "dynamic_walls", "delta_sph"})
    EXPECT_EQ(run_named(scheme, scene).particles, 20 * 7 - 4 * 4) << scheme;
}

// A run holds the arrays that its policies and its scene read, and no others.

using Names = std::set<std::string>;

const Names state{"x", "z", "velocity_x", "velocity_z", "density", "mass"};

Scene scene_of(const std::string& variant) {
  Scene scene = surging_scene(0.05, 0.002);
  scene.sample_interval = scene.duration;
  scene.initial_state = InitialState::lattice;
  scene.variant = variant;
  return scene;
}
RunOutput recommended_run(const std::string& variant) {
  return run("recommended", scene_of(variant), {});
}

Names held_for(const std::string& purpose, const RunOutput& output) {
  Names names;
  for (const HeldArray& array : output.held_arrays)
    if (array.purpose == purpose) names.insert(array.name);
  return names;
}
Names purposes(const RunOutput& output) {
  Names purposes;
  for (const HeldArray& array : output.held_arrays) purposes.insert(array.purpose);
  return purposes;
}
Names with(Names names, const Names& others) {
  names.insert(others.begin(), others.end());
  return names;
}

TEST(HeldArrays, OfTheRecommendedSchemeAreStateRatesNeighboursAndWhatIsRecorded) {
  const RunOutput output = recommended_run("");
  EXPECT_EQ(purposes(output), (Names{"state", "rates", "neighbours", "record"}));
  EXPECT_EQ(held_for("state", output), state);
  EXPECT_EQ(held_for("rates", output), (Names{"acceleration_x", "acceleration_z", "density_rate"}));
  EXPECT_EQ(held_for("neighbours", output),
            (Names{"sources", "clusters", "lists", "cells", "images", "order", "built_places"}));
  EXPECT_EQ(held_for("record", output), with(state, {"push_x", "push_z"}));
}

TEST(HeldArrays, AreNoneOfATermThatIsLeftOut) {
  for (const char* variant : {"no_viscosity", "no_diffusion", "linear_state", "wendland_c2"})
    EXPECT_EQ(purposes(recommended_run(variant)), purposes(recommended_run(""))) << variant;
}

TEST(HeldArrays, GrowByThoseOfATermThatIsAdded) {
  EXPECT_EQ(held_for("density gradient", recommended_run("antuono")),
            (Names{"density_gradient_x", "density_gradient_z", "density_gradient_of_sources"}));
  EXPECT_EQ(held_for("saved state", recommended_run("predictor_corrector")), state);
  EXPECT_EQ(held_for("state", recommended_run("verlet")),
            with(state, {"earlier_velocity_x", "earlier_velocity_z", "earlier_density"}));
}

TEST(HeldArrays, HaveASpacingOfEachParticleWhereThereAreTwo) {
  Scene scene = scene_of("");
  EXPECT_EQ(held_for("state", run("li2010", scene, {})), state);
  scene.surface_particle_spacing = 0.025;
  const RunOutput output = run("li2010", scene, {});
  EXPECT_EQ(held_for("state", output), with(state, {"spacing"}));
  EXPECT_EQ(held_for("solids", output), Names{});
}

TEST(HeldArrays, AreOfImagesOrOfSolidsAsTheWallsAreMade) {
  const RunOutput ghosts = recommended_run("ghost_walls");
  EXPECT_FALSE(held_for("neighbours", ghosts).contains("images"));
  EXPECT_EQ(held_for("solids", ghosts), (Names{"places", "nodes", "room"}));
  EXPECT_EQ(held_for("solids", recommended_run("dynamic_walls")),
            (Names{"places", "x", "z", "velocity_x", "velocity_z", "density", "density_rate"}));
}

TEST(HeldArrays, OfTheEnergyBudgetAreThereWhereItIsRecorded) {
  Scene scene = scene_of("");
  scene.record_energy_budget = true;
  EXPECT_EQ(held_for("energy budget", run("recommended", scene, {})),
            (Names{"acceleration_x", "acceleration_z", "density_rate"}));
}

TEST(HeldArrays, AreCountedByWhatTheyHaveTaken) {
  Array<double> array;
  array.reserve(10);
  HeldArrays arrays;
  arrays.add("state", "x", Array<double>());
  EXPECT_TRUE(arrays.held().empty());
  arrays.add("state", "x", array);
  arrays.add("state", "x", array);
  arrays.add("state", "z", array);
  ASSERT_EQ(arrays.held().size(), 2U);
  EXPECT_EQ(arrays.held()[0].bytes, 2 * 10 * sizeof(double));
}

}  // namespace
}  // namespace slosh::sph::simulation_test

// A run holds the arrays that its policies and its scene read, and no others.
#include "sph/held_arrays.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "sph/neighbours/particles.hpp"
#include "sph/tests/surging_scene.hpp"

namespace slosh::sph::held_arrays_test {
namespace {

using Names = std::set<std::string>;

const Names state{"x", "z", "velocity_x", "velocity_z", "density", "mass"};

Scene scene_of(const std::string& variant) {
  Scene scene = surging_scene(0.05, 0.02);
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
}  // namespace slosh::sph::held_arrays_test

#include "sph/terms/gap_friction.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "sph/tests/free_oscillation.hpp"
#include "sph/tests/rolling_scene.hpp"

namespace slosh::sph::gap_friction_test {
namespace {

double decay_with(double gap_friction) {
  Scene scene = released_scene(0.02, 3);
  scene.gap_friction = gap_friction;
  const FreeOscillation oscillation = free_oscillation("recommended", scene);
  EXPECT_GE(zero_crossings(oscillation).size(), 4);
  return decay_rate(oscillation);
}

// Of the energy, half is kinetic: an amplitude decays at half the rate of a velocity. Measured:
// 0.983 and 0.996 times that.
TEST(GapFriction, DampsAFreeWaveAtHalfItsRate) {
  const double without = decay_with(0);
  for (const double rate : {0.3, 1.0})
    EXPECT_NEAR(decay_with(rate) - without, 0.5 * rate, 0.03 * 0.5 * rate) << rate;
}

double largest(const std::vector<double>& values) {
  double result = 0;
  for (const double value : values) result = std::max(result, std::abs(value));
  return result;
}

// The friction is relative to the walls, which move in the one frame and stand in the other.
TEST(GapFriction, GivesTheSameSurgeInBothFrames) {
  Scene scene = surging_scene(0.025, 0.5);
  scene.gap_friction = 5;
  const RunOutput earth = run("recommended", scene, {});
  scene.roll = no_roll();
  const RunOutput tank = run("recommended", scene, {});
  const std::vector<double>&a = earth.elevation.at("left").value,
        &b = tank.elevation.at("left").value;
  ASSERT_EQ(a.size(), b.size());
  double difference = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    difference = std::max(difference, std::abs(a[i] - b[i]));
  EXPECT_LE(difference, 2e-3 * largest(a));
}

const std::vector<double>& budget(const RunOutput& output, const std::string& name) {
  for (const RecordedSeries& series : output.energy)
    if (series.name == name) return series.history.value;
  throw std::out_of_range(name);
}

// Measured: a residual of 4e-4 of the work, and 0.80 J/m dissipated instead of 0.019 J/m.
TEST(GapFriction, DissipatesEnergyThatTheBudgetCounts) {
  Scene scene = surging_and_rolling_scene(0.02, 1);
  scene.record_energy_budget = true;
  const RunOutput without = run("recommended", scene, {});
  scene.gap_friction = 1;
  const RunOutput with = run("recommended", scene, {});
  const double work = largest(budget(with, "wall_work"));
  EXPECT_LE(largest(budget(with, "energy_residual")), 1e-3 * work);
  EXPECT_GE(budget(with, "dissipated_energy").back(),
            5 * budget(without, "dissipated_energy").back());
}

// The friction takes at most a tenth of the velocity in a step.
TEST(GapFriction, ShortensTheStepWhereItIsStrong) {
  Scene scene = surging_scene(0.025, 0.02);
  const double step = stable_time_step("recommended", scene);
  scene.gap_friction = 10;
  EXPECT_EQ(stable_time_step("recommended", scene), step);
  scene.gap_friction = 1000;
  EXPECT_NEAR(stable_time_step("recommended", scene), 1e-4, 1e-12);
  const RunOutput output = run("recommended", scene, {});
  EXPECT_LE(largest(output.elevation.at("left").value), 0.01);
}

TEST(GapFriction, IsRefusedWhereAFixedStepIsTooLongForIt) {
  Scene scene = surging_scene(0.025, 0.01);
  scene.gap_friction = 199;
  EXPECT_NO_THROW(run("li2010", scene, {}));
  scene.gap_friction = 201;
  EXPECT_THROW(run("li2010", scene, {}), std::invalid_argument);
}

}  // namespace
}  // namespace slosh::sph::gap_friction_test

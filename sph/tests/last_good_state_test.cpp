#include <gtest/gtest.h>

#include <limits>
#include <optional>

#include "sph/restart/resume.hpp"
#include "sph/restart/saved_state.hpp"
#include "sph/tests/surging_scene.hpp"

namespace slosh::sph::last_good_state_test {
namespace {

// A tank whose motion is no number from a time on, sampled every 0.01 s.
Scene scene_that_goes_wrong(std::optional<SavedState>& last_good, double from = 0.125) {
  Scene scene = surging_scene(0.05, 0.2);
  for (auto* motion : {&scene.displacement, &scene.velocity, &scene.acceleration})
    *motion = [of = *motion, from](double t) {
      return t > from ? std::numeric_limits<double>::quiet_NaN() : of(t);
    };
  scene.save_last_good_state = [&](const SavedState& state) { last_good = state; };
  return scene;
}

class LastGoodStateOf : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Schemes, LastGoodStateOf,
                         testing::Values("li2010", "recommended", "zhao2021_moving"),
                         [](const auto& scheme) { return std::string(scheme.param); });

TEST_P(LastGoodStateOf, IsThatOfTheLastSampleBeforeTheRunWentWrong) {
  std::optional<SavedState> last_good;
  EXPECT_THROW(run(GetParam(), scene_that_goes_wrong(last_good), {}), SimulationError);
  ASSERT_TRUE(last_good);
  EXPECT_NEAR(last_good->numbers.at("time"), 0.12, 1e-9);
  EXPECT_EQ(last_good->numbers.at("sample"), 12);
  EXPECT_EQ(last_good->output.kinetic_energy.time.size(), 13u);
}

TEST_P(LastGoodStateOf, CanBeGoneOnFrom) {
  std::optional<SavedState> last_good;
  EXPECT_THROW(run(GetParam(), scene_that_goes_wrong(last_good), {}), SimulationError);
  Scene mended = surging_scene(0.05, 0.2);
  const RunOutput whole = run(GetParam(), mended, {});
  mended.resume = &last_good.value();
  const RunOutput resumed = run(GetParam(), mended, {});
  ASSERT_EQ(resumed.kinetic_energy.time.size(), 21u);
  // The neighbour lists are made anew, which changes the order of the sums.
  EXPECT_NEAR(resumed.kinetic_energy.value.back(), whole.kinetic_energy.value.back(),
              1e-9 * whole.kinetic_energy.value.back());
}

// The start can be made again.
TEST(LastGoodState, IsNotGivenWhereTheRunGoesWrongBeforeItsFirstSample) {
  std::optional<SavedState> last_good;
  EXPECT_THROW(run("recommended", scene_that_goes_wrong(last_good, 0.002), {}), SimulationError);
  EXPECT_FALSE(last_good);
}

TEST(LastGoodState, IsOfTheSampleBeforeTheOneThatShowsEnergyFromNowhere) {
  std::optional<SavedState> last_good;
  Scene scene = still_scene(0.04, 4);
  scene.initial_wave = InitialWave{1, 0.04};
  scene.numbers.sound_speed_ratio = 5;
  scene.numbers.courant_number = 1.8;
  scene.save_last_good_state = [&](const SavedState& state) { last_good = state; };
  EXPECT_THROW(run("recommended", scene, {}), SimulationError);
  ASSERT_TRUE(last_good);
  EXPECT_EQ(last_good->output.kinetic_energy.time.back(), last_good->numbers.at("time"));
  EXPECT_EQ(last_good->output.elevation.at("left").time.back(), last_good->numbers.at("time"));
}

TEST(LastGoodState, IsNotGivenOfARunThatEnds) {
  Scene scene = still_scene(0.05, 0.02);
  scene.save_last_good_state = [](const SavedState&) { FAIL(); };
  run("recommended", scene, {});
}

}  // namespace
}  // namespace slosh::sph::last_good_state_test

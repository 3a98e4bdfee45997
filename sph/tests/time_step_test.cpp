#include "sph/terms/time_step.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "sph/scheme.hpp"
#include "sph/schemes.hpp"
#include "sph/tests/surging_scene.hpp"

namespace slosh::sph::time_step_test {
namespace {

const Setting setting = setting_of(still_scene(0.01, 1), Recommended::numbers);
const double h = setting.smoothing_length(), c0 = setting.speed_of_sound;

TEST(AdaptiveStep, IsTheCourantNumberTimesHOverTheLargestSpeedOfSound) {
  const AdaptiveStep step(setting);
  EXPECT_NEAR(step(0, c0), 0.8 * h / c0, 1e-12 * h / c0);
  EXPECT_NEAR(step(0, 1.6 * c0), 0.8 * h / (1.6 * c0), 1e-12 * h / c0);
  EXPECT_EQ(step(0, 0.5 * c0), step(0, c0));  // a liquid that is stretched does not lengthen it
}

TEST(AdaptiveStep, IsShortEnoughForTheLargestAcceleration) {
  const double acceleration = 1e6;
  EXPECT_NEAR(AdaptiveStep(setting)(acceleration, c0), 0.25 * std::sqrt(h / acceleration), 1e-15);
}

TEST(EquationsOfState, GiveTheSpeedOfSoundOfTheirOwnPressure) {
  const auto slope = [](const auto& state, double density) {
    return std::sqrt((state.pressure(density + 0.01) - state.pressure(density - 0.01)) / 0.02);
  };
  for (const double density : {900.0, 1000.0, 1200.0}) {
    const Tait tait(1000, c0);
    EXPECT_NEAR(tait.speed_of_sound_at(density), slope(tait, density), 1e-6 * c0);
    const LinearState linear(setting);
    EXPECT_NEAR(linear.speed_of_sound_at(density), slope(linear, density), 1e-6 * c0);
  }
}

}  // namespace
}  // namespace slosh::sph::time_step_test

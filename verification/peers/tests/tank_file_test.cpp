// The file that a driver reads: the case's numbers, its motion as a table, and what it refuses.
#include "verification/peers/tank_file.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "verification/case/motion.hpp"

namespace slosh::tank_file_test {
namespace {

CaseDefinition surging_tank() {
  CaseDefinition definition{};
  definition.gravity = 9.81;
  definition.tank = {.length = 1, .height = 0.6};
  definition.liquid = {.fill_depth = 0.35, .density = 998, .kinematic_viscosity = 1e-6};
  definition.motion.surge = SineMotion{.amplitude = 0.02, .angular_frequency = 3};
  definition.start = Start::earth;
  definition.duration = 2.015;  // not a whole number of samples
  definition.sample_interval = 0.02;
  definition.gauges = {{"left", 0.05}, {"right", 0.95}};
  return definition;
}

TEST(TankFile, HoldsTheCaseInItsUnits) {
  const auto file = nlohmann::json::parse(tank_file(surging_tank()));
  EXPECT_EQ(file.at("length_m"), 1);
  EXPECT_EQ(file.at("height_m"), 0.6);
  EXPECT_EQ(file.at("fill_depth_m"), 0.35);
  EXPECT_EQ(file.at("gravity_m_s2"), 9.81);
  EXPECT_EQ(file.at("density_kg_m3"), 998);
  EXPECT_EQ(file.at("kinematic_viscosity_m2_s"), 1e-6);
  EXPECT_EQ(file.at("gauges").at(1).at("name"), "right");
  EXPECT_EQ(file.at("gauges").at(1).at("x_m"), 0.95);
  EXPECT_EQ(file.at("duration_s"), 2.015);
  EXPECT_EQ(file.at("sample_interval_s"), 0.02);
  EXPECT_EQ(file.at("initial_wave").at("amplitude_m"), 0);
}

TEST(TankFile, HoldsTheInitialWave) {
  CaseDefinition definition = surging_tank();
  definition.initial_wave = InitialWaveDefinition{.mode = 2, .amplitude = 0.01};
  const auto file = nlohmann::json::parse(tank_file(definition));
  EXPECT_EQ(file.at("initial_wave").at("mode"), 2);
  EXPECT_EQ(file.at("initial_wave").at("amplitude_m"), 0.01);
}

TEST(TankFile, TabulatesTheAccelerationFinelyUpToTheEnd) {
  const CaseDefinition definition = surging_tank();
  const auto motion = nlohmann::json::parse(tank_file(definition)).at("motion");
  const auto times = motion.at("time_s").get<std::vector<double>>();
  const auto values = motion.at("acceleration_x_m_s2").get<std::vector<double>>();
  ASSERT_EQ(times.size(), values.size());
  EXPECT_EQ(times.front(), 0);
  EXPECT_EQ(times.back(), definition.duration);
  for (std::size_t i = 1; i < times.size(); ++i) {
    EXPECT_LE(times[i] - times[i - 1], 0.002 + 1e-12);
    // Between two points the straight line is as good as the motion: (3 * 0.002)^2 / 8 of it.
    const double middle = (times[i - 1] + times[i]) / 2;
    EXPECT_NEAR((values[i - 1] + values[i]) / 2, surge_motion(definition).acceleration(middle),
                1e-5 * 0.02 * 9);
  }
}

TEST(TankFile, SetsTheLiquidOffAgainstATankThatStartsInTheEarthsFrame) {
  CaseDefinition definition = surging_tank();
  const auto velocity = [&] {
    return nlohmann::json::parse(tank_file(definition))
        .at("motion")
        .at("initial_velocity_x_m_s")
        .get<double>();
  };
  EXPECT_NEAR(velocity(), -0.06, 1e-15);
  definition.start = Start::tank;
  EXPECT_EQ(velocity(), 0);
}

TEST(TankFile, RefusesWhatItHasNoPlaceFor) {
  CaseDefinition rolls = surging_tank(), blocked = surging_tank(), dam = surging_tank(),
                 sloped = surging_tank();
  rolls.motion.roll = RollDefinition{SineMotion{.amplitude = 0.1, .angular_frequency = 3}, 0.5, 0};
  blocked.obstacles.push_back({"baffle", 0.4, 0.5, 0, 0.1});
  dam.liquid.column_width = 0.3;
  sloped.tank.outline = {{0, 0}, {1, 0}, {0, 1}};
  for (const CaseDefinition& definition : {rolls, blocked, dam, sloped})
    EXPECT_THROW(tank_file(definition), std::invalid_argument);
}

}  // namespace
}  // namespace slosh::tank_file_test

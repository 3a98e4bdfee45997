#include "sph/guards/energy_bound.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "sph/simulation.hpp"
#include "sph/tests/surging_scene.hpp"

namespace slosh::sph::energy_bound_test {
namespace {

// Two particles of 100 kg/m each; the slack is 0.005 rho g h^2 L = 6.0086 J/m.
Particles liquid() {
  Particles p;
  p.x = p.z = p.density = {1, 2};
  p.velocity_x = {0.1, -3};
  p.velocity_z = {0, 0};
  p.mass = {100, 100};
  return p;
}

class AnEnergyBound : public testing::Test {
 protected:
  bool holds(double time, double gained, double power, double tank_speed) {
    try {
      bound.check(time, gained, power, tank_speed, liquid());
      return true;
    } catch (const SimulationError& error) {
      complaint = error.what();
      return false;
    }
  }
  EnergyBound bound{still_scene(0.05, 1), liquid()};
  std::string complaint;
};

TEST_F(AnEnergyBound, LeavesTheStillLiquidAHundredthOfItsPotentialEnergy) {
  EXPECT_TRUE(holds(0, 6.0, 0, 0));
  EXPECT_FALSE(holds(1, 6.02, 0, 0));
}

TEST_F(AnEnergyBound, LeavesTwiceTheWorkOfTheWallsInEitherDirection) {
  EXPECT_TRUE(holds(0, 0, 0, 0));
  EXPECT_TRUE(holds(1, 6.0 + 10, -10, 0));
  EXPECT_TRUE(holds(2, 6.0 + 30, 10, 0) && holds(2, 6.0 + 30, 10, 0));
  EXPECT_FALSE(holds(2, 6.02 + 30, 10, 0));
}

TEST_F(AnEnergyBound, LeavesWhatATankThatIsSetOffOrStoppedGivesAtOnce) {
  EXPECT_TRUE(holds(0, 6.0 + 2 * 200 * 0.25, 0, 0.5));
  EXPECT_FALSE(holds(1, 6.02 + 2 * 200 * 0.25, 0, 0));
}

TEST_F(AnEnergyBound, NamesTheFastestParticleTheTimeAndBothEnergies) {
  EXPECT_FALSE(holds(1.5, 100, 0, 0));
  for (const char* part : {"particle 1 is the fastest", "t = 1.5 s", "gained 100 J/m", "6.009 J/m"})
    EXPECT_NE(complaint.find(part), std::string::npos) << part << " is not in " << complaint;
}

TEST_F(AnEnergyBound, HoldsForNothingThatIsNoNumber) {
  EXPECT_FALSE(holds(1, std::numeric_limits<double>::quiet_NaN(), 0, 0));
  EXPECT_FALSE(holds(2, 0, std::numeric_limits<double>::quiet_NaN(), 0));
}

// A free wave whose step is half as long again as a lattice bears: its particles' noise saturates
// at five times the wave's energy, with every density in range.
TEST(EnergyBoundOfARun, StopsAnUnstableStepThatLeavesEveryDensityInRange) {
  Scene scene = still_scene(0.04, 4);
  scene.fill_depth = 0.4;
  scene.initial_wave = InitialWave{1, 0.04};
  scene.numbers.sound_speed_ratio = 5;
  scene.numbers.courant_number = 2.0;
  try {
    run("recommended", scene, {});
    FAIL() << "the run went on";
  } catch (const SimulationError& error) {
    EXPECT_NE(std::string(error.what()).find("is the time step too long?"), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace slosh::sph::energy_bound_test

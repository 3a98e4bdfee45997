// What stops a run that goes wrong.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "sph/guards/energy_bound.hpp"
#include "sph/guards/stability_guard.hpp"
#include "sph/simulation.hpp"
#include "sph/start/initial_lattice.hpp"
#include "sph/terms/equation_of_state.hpp"
#include "sph/tests/surging_scene.hpp"
#include "verification/tests/messages.hpp"

namespace slosh::sph::guards_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Particles lattice() {
  const Scene scene = still_scene(0.05, 1);
  return initial_lattice(
      scene, [&](double pressure) { return Tait(scene.rest_density, 20).density(pressure); });
}

std::string complaint_about(const Particles& particles, double time) {
  return message_of<SimulationError>([&] { check_state(particles, 1000, time); });
}

TEST(StabilityGuard, LetsTheStillLiquidPass) { EXPECT_EQ(complaint_about(lattice(), 0), ""); }

TEST(StabilityGuard, NamesTheParticleAndTheTimeOfAStateThatIsNotFinite) {
  for (Array<double> Particles::*field : {&Particles::x, &Particles::z, &Particles::velocity_x,
                                          &Particles::velocity_z, &Particles::density})
    for (double bad : {nan, std::numeric_limits<double>::infinity()}) {
      Particles particles = lattice();
      (particles.*field)[17] = bad;
      const std::string complaint = complaint_about(particles, 1.25);
      EXPECT_TRUE(slosh::holds(complaint, "particle 17 "));
      EXPECT_TRUE(slosh::holds(complaint, "t = 1.25 s"));
      EXPECT_TRUE(slosh::holds(complaint, "not finite"));
    }
}

TEST(StabilityGuard, NamesTheParticleWhoseDensityIsOutOfRange) {
  for (double density : {190.0, 2010.0, 0.0, -1000.0}) {
    Particles particles = lattice();
    particles.density[3] = density;
    const std::string complaint = complaint_about(particles, 0.5);
    EXPECT_TRUE(slosh::holds(complaint, "particle 3 "));
    EXPECT_TRUE(slosh::holds(complaint, "t = 0.5 s"));
    EXPECT_TRUE(slosh::holds(complaint, "density range"));
  }
}

// A liquid that a tank which stops within 10 ms throws against the wall at three times its sound.
Scene thrown_scene() {
  Scene scene = still_scene(0.05, 0.2);
  constexpr double speed = 20, span = 0.01;
  scene.displacement = [=](double t) {
    const double braked = std::min(t, span);
    return speed * (braked - 0.5 * braked * braked / span);
  };
  scene.velocity = [=](double t) { return t < span ? speed * (1 - t / span) : 0.0; };
  scene.acceleration = [=](double t) { return t < span ? -speed / span : 0.0; };
  scene.start = Start::tank;
  scene.numbers.sound_speed_ratio = 0.3;
  return scene;
}

TEST(StabilityGuard, StopsARunThatDiverges) {
  for (const std::string& scheme : scheme_names())
    EXPECT_THROW(run(scheme, thrown_scene(), {}), SimulationError) << scheme;
}

TEST(StabilityGuard, StopsARunAtTheStepThatWentWrongAndNotAtTheNextSample) {
  Scene scene = thrown_scene();
  scene.sample_interval = 0.1;
  const std::string message = message_of<SimulationError>([&] { run("recommended", scene, {}); });
  EXPECT_TRUE(slosh::holds(message, "is not finite at t = ")) << message;
  EXPECT_FALSE(slosh::holds(message, "t = 0.1 s")) << message;
  EXPECT_FALSE(slosh::holds(message, "t = 0.2 s")) << message;
}

TEST(StabilityGuard, NamesTheParticleThatAsksForAStepBelowTheLimit) {
  const Particles particles = lattice();
  Rates rates;
  rates.resize(particles.size());
  for (auto* field : {&rates.acceleration_x, &rates.acceleration_z, &rates.density_rate})
    std::fill(field->begin(), field->end(), 1.0);
  rates.acceleration_z[11] = -3e9;
  EXPECT_NO_THROW(check_step(1.1e-7, 1e-3, particles, rates, 2));
  for (const double step : {0.9e-7, 0.0, nan}) {
    const std::string message =
        message_of<SimulationError>([&] { check_step(step, 1e-3, particles, rates, 2); });
    EXPECT_TRUE(slosh::holds(message, "particle 11 is accelerated by 3e+09 m/s2")) << step;
    EXPECT_TRUE(slosh::holds(message, "t = 2 s"));
  }
}

TEST(StabilityGuard, StopsARunWhoseTankIsJerkedBeyondAnyStep) {
  Scene scene = still_scene(0.05, 0.2);
  scene.acceleration = [](double t) { return t > 0.1 ? 1e12 : 0.0; };
  EXPECT_THROW(run("zhao2021_fixed", scene, {}), SimulationError);
}

TEST(StabilityGuard, StopsARunWhoseTankMovesByNotANumber) {
  Scene scene = still_scene(0.05, 0.2);
  scene.acceleration = [](double t) { return t > 0.1 ? nan : 0.0; };
  EXPECT_THROW(run("recommended", scene, {}), SimulationError);
}

TEST(StabilityGuard, RefusesAFixedStepThatIsUnstableAndSaysTheLimit) {
  try {
    run("li2010", surging_scene(0.005, 0.1), {});
    FAIL() << "5 mm was let pass";
  } catch (const SimulationError& error) {
    // 0.65 h / c0 = 0.65 * 0.0075 m / (10 * (1.8530 + 0.0297) m/s)
    EXPECT_TRUE(slosh::holds(error.what(), "0.000259 s"));
    EXPECT_TRUE(slosh::holds(error.what(), "0.005 m"));
  }
}

// The finer of two spacings decides.
TEST(StabilityGuard, RefusesAFixedStepThatIsUnstableAtTheSurface) {
  Scene scene = surging_scene(0.02, 0.1);
  scene.surface_particle_spacing = 0.005;
  EXPECT_THROW(run("li2010", scene, {}), SimulationError);
}

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
    EXPECT_TRUE(slosh::holds(complaint, part)) << part << " is not in ";
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
  EXPECT_TRUE(slosh::holds(message_of<SimulationError>([&] { run("recommended", scene, {}); }),
                           "is the time step too long?"));
}

}  // namespace
}  // namespace slosh::sph::guards_test

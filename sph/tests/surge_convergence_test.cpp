// Runs against linear theory, small surge of Li et al. 2010, section 4.1, and a violent roll.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "reference/linear_surge.hpp"
#include "sph/simulation.hpp"
#include "sph/tests/free_oscillation.hpp"
#include "sph/tests/surging_scene.hpp"

namespace slosh::sph::surge_convergence_test {
namespace {

const reference::Tank tank{.length = 1, .fill_depth = 0.35, .gravity = 9.81, .density = 1000};

// rms of the difference from linear theory at the right gauge over the rms of theory, from 1 s on:
// no grid resolves the impulsive start's highest modes.
double error_of_the_surge(const std::string& scheme, double spacing) {
  const Scene scene = surging_scene(spacing, 10);
  const reference::LinearSurge theory(
      tank, reference::Start::earth,
      reference::SineSurge{.amplitude = 0.02, .angular_frequency = surge_frequency}, 1000);
  const History computed = run(scheme, scene, {}).elevation.at("right");
  double error2 = 0, theory2 = 0;
  for (std::size_t i = 0; i < computed.time.size(); ++i) {
    if (computed.time[i] < 1) continue;
    const double expected = theory.elevation(0.45, computed.time[i]);
    error2 += std::pow(computed.value[i] - expected, 2);
    theory2 += expected * expected;
  }
  return std::sqrt(error2 / theory2);
}

TEST(Recommended, ApproachesLinearTheoryAsTheParticlesGetSmaller) {
  const double coarse = error_of_the_surge("recommended", 0.025),
               fine = error_of_the_surge("recommended", 0.0125);
  // Measured: 0.177 and 0.100. The wave is 0.4 and 0.7 of a particle spacing high.
  EXPECT_LE(coarse, 0.22);
  EXPECT_LE(fine, 0.13);
  EXPECT_LE(fine, 0.75 * coarse);
}

// At the gauge, in the first 0.1 s, from the velocity of potential flow: no sound hides it.
TEST(Recommended, StartsAlongLinearTheory) {
  const Scene scene = surging_scene(0.01, 0.1);
  const reference::LinearSurge theory(
      tank, reference::Start::earth,
      reference::SineSurge{.amplitude = 0.02, .angular_frequency = surge_frequency}, 1000);
  const History computed = run("recommended", scene, {}).elevation.at("right");
  for (std::size_t i = 1; i < computed.time.size(); ++i) {
    const double expected = theory.elevation(0.45, computed.time[i]);
    EXPECT_NEAR(computed.value[i], expected, 0.03 * std::abs(expected)) << computed.time[i];
  }
}

double relative_frequency(const FreeOscillation& oscillation) {
  return natural_frequency(oscillation) / reference::natural_frequency(tank, 1);
}

// Measured: 0.9 % above linear theory, decay 0.012 1/s.
TEST(RecommendedWithWendlandC2, OscillatesAtTheNaturalFrequencyAndHardlyDecays) {
  Scene scene = released_scene(0.0125, 7);
  scene.variant = "wendland_c2";
  const FreeOscillation oscillation = free_oscillation("recommended", scene);
  ASSERT_GE(zero_crossings(oscillation).size(), 10);
  EXPECT_NEAR(relative_frequency(oscillation), 1, 0.015);
  EXPECT_LE(std::abs(decay_rate(oscillation)), 0.03);
}

// Measured: 0.1 % below linear theory, decay 0.009 1/s.
TEST(Recommended, OscillatesAtTheNaturalFrequencyAndHardlyDecays) {
  const FreeOscillation oscillation = free_oscillation("recommended", released_scene(0.0125, 7));
  ASSERT_GE(zero_crossings(oscillation).size(), 10);
  EXPECT_NEAR(relative_frequency(oscillation), 1, 0.005);
  EXPECT_LE(std::abs(decay_rate(oscillation)), 0.03);
}

// Measured: 0.82 times the mirrors' decay, 0.05 % above their frequency. Fixed particles whose
// lattice catches on the liquid's raise the frequency by 0.8 % and decay four times as fast.
TEST(GhostWalls, LetAFreeWaveOscillateAndDecayNearlyAsMirrorParticlesDo) {
  Scene scene = released_scene(0.02, 10);
  const FreeOscillation mirrors = free_oscillation("recommended", scene);
  scene.variant = "ghost_walls";
  const FreeOscillation ghosts = free_oscillation("recommended", scene);
  EXPECT_NEAR(natural_frequency(ghosts) / natural_frequency(mirrors), 1, 0.001);
  EXPECT_GT(decay_rate(mirrors), 0);
  EXPECT_LT(decay_rate(ghosts), 1.3 * decay_rate(mirrors));
}

// Artificial viscosity acts as nu = alpha h c0 / 8 (Monaghan 2005, section 8.5), and a mode decays
// with 2 nu k^2, here 0.86 1/s: the paper's scheme must show it. Its viscosity acts on approaching
// pairs alone and its walls do not let slip, so that the rate is only near to it: measured 1.08
// 1/s.
TEST(Li2010, DampsTheFirstModeByItsArtificialViscosity) {
  const double spacing = 0.0125;
  const FreeOscillation oscillation = free_oscillation("li2010", released_scene(spacing, 3));
  ASSERT_GE(zero_crossings(oscillation).size(), 4);
  const double speed_of_sound = 10 * std::sqrt(tank.gravity * tank.fill_depth);
  const double viscosity = 1.5 * spacing * speed_of_sound / 8;
  const double wave_number = std::numbers::pi / tank.length;
  const double expected = 2 * viscosity * wave_number * wave_number;
  EXPECT_NEAR(decay_rate(oscillation), expected, 0.5 * expected);
  EXPECT_NEAR(relative_frequency(oscillation), 1, 0.03);
}

// Returns the decay of a free wave in a liquid of this viscosity [1/s].
double decay_with(const char* variant, double kinematic_viscosity) {
  Scene scene = released_scene(0.01, 4);
  scene.variant = variant;
  scene.kinematic_viscosity = kinematic_viscosity;
  const FreeOscillation oscillation = free_oscillation("recommended", scene);
  EXPECT_GE(zero_crossings(oscillation).size(), 5);
  return decay_rate(oscillation);
}

// The Stokes layers at the walls add
//   sqrt(nu omega / 2) (1 / L + k (1 - 2 h / L) / sinh(2 k h))
// to the decay rate, without the gap walls (Keulegan 1959, J. Fluid Mech. 6, 33-50).
// They are 2.8 spacings thick. Measured: 1.47 times this, and 1.26 times in layers of 5.7 spacings
// (nu = 8e-3).
TEST(NoSlipLaminar, DampsTheFirstModeByItsStokesLayersToo) {
  const double viscosity = 2e-3, k = std::numbers::pi / tank.length, h = tank.fill_depth;
  const double expected = std::sqrt(0.5 * viscosity * reference::natural_frequency(tank, 1)) *
                          (1 / tank.length + k * (1 - 2 * h / tank.length) / std::sinh(2 * k * h));
  const double more =
      decay_with("no_slip_laminar", viscosity) - decay_with("laminar_viscosity", viscosity);
  EXPECT_GE(more, 0.9 * expected);
  EXPECT_LE(more, 1.6 * expected);
}

// The tank of SPHERIC's benchmark 10 with water at a fifth of its height, rolling near its natural
// frequency: waves break and run up the walls.

Scene violent_scene(const std::string& scheme) {
  Scene scene = still_scene(0.01, 3);
  scene.tank_length = 0.9;
  scene.tank_height = 0.508;
  scene.fill_depth = 0.093;
  scene.gauges.clear();
  const double angle = 4 * std::numbers::pi / 180, omega = 3.85;
  scene.roll =
      Roll{[=](double t) { return angle * std::sin(omega * t); },
           [=](double t) { return angle * omega * std::cos(omega * t); },
           [=](double t) { return -angle * omega * omega * std::sin(omega * t); }, 0.45, 0};
  scene.snapshot_interval = 0.1;
  if (scheme.starts_with("zhao2021")) scene.numbers.artificial_viscosity = 0.1;
  return scene;
}

class ViolentRoll : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Of, ViolentRoll, testing::ValuesIn(scheme_names()),
                         [](const auto& scheme) { return scheme.param; });

TEST_P(ViolentRoll, KeepsEveryParticleInTheTank) {
  Scene scene = violent_scene(GetParam());
  std::size_t seen = 0, outside = 0;
  // What a step carries beyond a wall is put back by the next.
  const double margin = 0.5 * scene.particle_spacing;
  const auto within = [=](double place, double length) {
    return place > -margin && place < length + margin;
  };
  scene.record_snapshot = [&](const Snapshot& s) {
    for (std::size_t i = 0; i < s.x.size(); ++i) {
      ++seen;
      if (!(within(s.x[i], scene.tank_length) && within(s.z[i], scene.tank_height))) ++outside;
    }
  };
  const RunOutput output = run(GetParam(), scene, {});
  EXPECT_EQ(seen, 31 * output.particles);
  EXPECT_EQ(outside, 0);
  // Measured: 20 by delta_sph, 3 by recommended, none by the others, of 810 particles in thousands
  // of steps.
  EXPECT_LE(output.exchanged_at_walls, 100);
}

}  // namespace
}  // namespace slosh::sph::surge_convergence_test

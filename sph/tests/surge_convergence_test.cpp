// Runs against linear theory: small surge of Li et al. 2010, section 4.1.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "reference/linear_surge.hpp"
#include "sph/simulation.hpp"
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

// The first mode of the elevation, sampled along the tank.
struct FreeOscillation {
  std::vector<double> time, first_mode;
};

// Released by a tank that stops: the liquid moves on at 0.03 m/s.
FreeOscillation free_oscillation(const std::string& scheme, double spacing, double duration,
                                 const std::string& variant = "") {
  Scene scene = still_scene(spacing, duration);
  scene.variant = variant;
  scene.velocity = [](double t) { return t > 0 ? 0.0 : 0.03; };
  scene.start = Start::tank;
  scene.gauges.clear();
  const int gauges = 20;
  for (int i = 0; i < gauges; ++i)
    scene.gauges.push_back({std::to_string(i), (i + 0.5) / gauges * scene.tank_length});
  const RunOutput output = run(scheme, scene, {});
  FreeOscillation oscillation{output.kinetic_energy.time, {}};
  oscillation.first_mode.resize(oscillation.time.size());
  for (const Gauge& gauge : scene.gauges)
    for (std::size_t k = 0; k < oscillation.time.size(); ++k)
      oscillation.first_mode[k] += output.elevation.at(gauge.name).value[k] *
                                   -std::cos(std::numbers::pi * gauge.x) * 2 / gauges;
  return oscillation;
}

std::vector<double> zero_crossings(const FreeOscillation& oscillation) {
  std::vector<double> crossings;
  const auto& [time, value] = oscillation;
  for (std::size_t k = 1; k + 1 < time.size(); ++k)
    if (value[k] * value[k + 1] < 0)
      crossings.push_back(time[k] - value[k] * (time[k + 1] - time[k]) / (value[k + 1] - value[k]));
  return crossings;
}

// [1/s], from the highest elevation between successive zero crossings, first to last.
double decay_rate(const FreeOscillation& oscillation) {
  const std::vector<double> crossings = zero_crossings(oscillation);
  std::vector<double> peaks(crossings.size() - 1);
  for (std::size_t k = 0; k < oscillation.time.size(); ++k) {
    const auto next = std::upper_bound(crossings.begin(), crossings.end(), oscillation.time[k]);
    if (next == crossings.begin() || next == crossings.end()) continue;
    double& peak = peaks[next - crossings.begin() - 1];
    peak = std::max(peak, std::abs(oscillation.first_mode[k]));
  }
  const double half_period =
      (crossings.back() - crossings.front()) / static_cast<double>(peaks.size());
  return std::log(peaks.front() / peaks.back()) /
         (half_period * static_cast<double>(peaks.size() - 1));
}

double natural_frequency(const FreeOscillation& oscillation) {
  const std::vector<double> crossings = zero_crossings(oscillation);
  return std::numbers::pi * static_cast<double>(crossings.size() - 1) /
         (crossings.back() - crossings.front());
}

double relative_frequency(const FreeOscillation& oscillation) {
  return natural_frequency(oscillation) / reference::natural_frequency(tank, 1);
}

// Measured: 0.9 % above linear theory, decay 0.012 1/s.
TEST(RecommendedWithWendlandC2, OscillatesAtTheNaturalFrequencyAndHardlyDecays) {
  const FreeOscillation oscillation = free_oscillation("recommended", 0.0125, 7, "wendland_c2");
  ASSERT_GE(zero_crossings(oscillation).size(), 10);
  EXPECT_NEAR(relative_frequency(oscillation), 1, 0.015);
  EXPECT_LE(std::abs(decay_rate(oscillation)), 0.03);
}

// Measured: 0.1 % below linear theory, decay 0.009 1/s.
TEST(Recommended, OscillatesAtTheNaturalFrequencyAndHardlyDecays) {
  const FreeOscillation oscillation = free_oscillation("recommended", 0.0125, 7);
  ASSERT_GE(zero_crossings(oscillation).size(), 10);
  EXPECT_NEAR(relative_frequency(oscillation), 1, 0.005);
  EXPECT_LE(std::abs(decay_rate(oscillation)), 0.03);
}

// Artificial viscosity acts as nu = alpha h c0 / 8 (Monaghan 2005, section 8.5), and a mode decays
// with 2 nu k^2, here 0.86 1/s: the paper's scheme must show it. Its viscosity acts on approaching
// pairs alone and its walls do not let slip, so that the rate is only near to it: measured 1.08
// 1/s.
TEST(Li2010, DampsTheFirstModeByItsArtificialViscosity) {
  const double spacing = 0.0125;
  const FreeOscillation oscillation = free_oscillation("li2010", spacing, 3);
  ASSERT_GE(zero_crossings(oscillation).size(), 4);
  const double speed_of_sound = 10 * std::sqrt(tank.gravity * tank.fill_depth);
  const double viscosity = 1.5 * spacing * speed_of_sound / 8;
  const double wave_number = std::numbers::pi / tank.length;
  const double expected = 2 * viscosity * wave_number * wave_number;
  EXPECT_NEAR(decay_rate(oscillation), expected, 0.5 * expected);
  EXPECT_NEAR(relative_frequency(oscillation), 1, 0.03);
}

}  // namespace
}  // namespace slosh::sph::surge_convergence_test

#include "sph/start/initial_surface.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "sph/schemes.hpp"
#include "sph/start/initial_lattice.hpp"
#include "sph/start/initial_state.hpp"
#include "sph/start/projection.hpp"
#include "sph/tests/surging_scene.hpp"

namespace slosh::sph::initial_surface_test {
namespace {

constexpr double pi = std::numbers::pi;

Scene waved_scene(int mode, double amplitude, double spacing = 0.025, double duration = 0) {
  Scene scene = still_scene(spacing, duration);
  scene.initial_wave = InitialWave{mode, amplitude};
  return scene;
}

const Scheme<Recommended>& scheme() {
  static const Scheme<Recommended> scheme(still_scene(0.025, 0));
  return scheme;
}
double density_at(double pressure) { return scheme().state.density(pressure); }

TEST(InitialSurface, IsACosineFromTheLeftWallAndLevelWithoutAWave) {
  const InitialSurface wave(waved_scene(3, 0.02)), level(still_scene(0.025, 0));
  for (const double x : {0.0, 0.2, 0.5, 1.0}) {
    EXPECT_NEAR(wave.height(x), 0.35 + 0.02 * std::cos(3 * pi * x), 1e-15);
    EXPECT_EQ(level.height(x), 0.35);
    EXPECT_NEAR(wave.pressure(x, 0.1), 1000 * 9.81 * (wave.height(x) - 0.1), 1e-10);
  }
  EXPECT_EQ(level.mean_height(0.1, 0.3), 0.35);
  const double integral = 0.02 * (std::sin(3 * pi * 0.3) - std::sin(3 * pi * 0.1)) / (3 * pi);
  EXPECT_NEAR(wave.mean_height(0.1, 0.3), 0.35 + integral / 0.2, 1e-15);
}

TEST(InitialSurface, RefusesAWaveThatTheTankCannotHold) {
  for (const double amplitude : {0.35, -0.4, 0.7, std::nan("")})
    EXPECT_THROW(InitialSurface{waved_scene(1, amplitude)}, std::invalid_argument) << amplitude;
  for (const int mode : {0, -1})
    EXPECT_THROW(InitialSurface{waved_scene(mode, 0.02)}, std::invalid_argument);
  Scene dam = waved_scene(1, 0.02), baffled = dam;
  dam.column_width = 0.5;
  baffled.obstacles = {{0.4, 0.6, 0, 0.1}};
  EXPECT_THROW(InitialSurface{dam}, std::invalid_argument);
  EXPECT_THROW(InitialSurface{baffled}, std::invalid_argument);
}

TEST(InitialLattice, FillsEveryColumnUpToTheWaveExactly) {
  for (const int mode : {1, 2, 5})
    for (const double spacing : {0.05, 0.025, 0.01}) {
      const Scene scene = waved_scene(mode, 0.02, spacing);
      const Particles p = initial_lattice(scene, density_at);
      double volume = 0, first_column = 0;
      for (std::size_t i = 0; i < p.size(); ++i) {
        volume += p.mass[i] / p.density[i];
        if (p.x[i] < spacing) first_column += p.mass[i] / p.density[i];
      }
      EXPECT_NEAR(volume, 0.35, 1e-13) << mode << " " << spacing;
      EXPECT_NEAR(first_column / spacing, InitialSurface(scene).mean_height(0, spacing), 1e-13);
    }
}

TEST(InitialLattice, CarriesTheHydrostaticPressureUnderTheWave) {
  const Scene scene = waved_scene(1, 0.02);
  const Particles p = initial_lattice(scene, density_at);
  for (std::size_t i = 0; i < p.size(); ++i)
    EXPECT_NEAR(scheme().state.pressure(p.density[i]),
                1000 * 9.81 * (0.35 + 0.02 * std::cos(pi * p.x[i]) - p.z[i]), 1e-7);
  EXPECT_LT(flattest_cell(lattice_of_volumes(scene)), 1 - 0.9 * 0.02 / 0.35);
}

// Linear theory's pressure at the moment of release, cosh(k z) / cosh(k h) of the surface's. The
// mean over the liquid is left out: it is still water's own error, a tenth of a spacing of depth.
TEST(Projected, FindsTheDepthProfileOfAWavesPressure) {
  const Scene scene = waved_scene(2, 0.02, 0.0125, 1);
  const Scheme<Recommended> own(scene);
  const Method method = method_of(own);
  const Particles state = projected(scene, method, start_lattice(scene, method));
  const double k = 2 * pi, weight = 1000 * 9.81;
  // The still liquid grows heavier with the depth.
  const auto still_pressure = [&, &numbers = own.setting](double depth) {
    const double compression = 9.81 * depth / std::pow(numbers.speed_of_sound, 2);
    return numbers.rest_density * 9.81 * depth * (1 + compression / 2);
  };
  std::vector<double> above_still, wave, hydrostatic;
  for (std::size_t i = 0; i < state.size(); ++i) {
    EXPECT_NEAR(std::hypot(state.velocity_x[i], state.velocity_z[i]), 0, 1e-12);
    if (state.z[i] > 0.25) continue;
    above_still.push_back(own.state.pressure(state.density[i]) - still_pressure(0.35 - state.z[i]));
    hydrostatic.push_back(weight * 0.02 * std::cos(k * state.x[i]));
    wave.push_back(hydrostatic.back() * std::cosh(k * state.z[i]) / std::cosh(k * 0.35));
  }
  const double mean = std::accumulate(above_still.begin(), above_still.end(), 0.0) /
                      static_cast<double>(above_still.size());
  EXPECT_LE(std::abs(mean), 0.15 * 0.0125 * weight);
  double error2 = 0, hydrostatic_error2 = 0, wave2 = 0;
  for (std::size_t i = 0; i < wave.size(); ++i) {
    error2 += std::pow(above_still[i] - mean - wave[i], 2);
    hydrostatic_error2 += std::pow(hydrostatic[i] - wave[i], 2);
    wave2 += wave[i] * wave[i];
  }
  EXPECT_LE(std::sqrt(error2 / wave2), 0.2);
  EXPECT_GE(std::sqrt(hydrostatic_error2 / wave2), 1);
}

TEST(Settled, IsRefusedForAWaveThatWouldRunMeanwhile) {
  Scene scene = waved_scene(1, 0.02, 0.025, 0.1);
  scene.initial_state = InitialState::settled;
  EXPECT_THROW(run("recommended", scene, {}), std::invalid_argument);
}

}  // namespace
}  // namespace slosh::sph::initial_surface_test

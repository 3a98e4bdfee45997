#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "sph/recording/free_surface.hpp"
#include "sph/tests/waved_lattice.hpp"

namespace slosh::sph::free_surface_gauge_test {
namespace {

double gauge(const Particles& particles, double x) {
  return surface_elevation(particles, 1, 0.35, x);
}

// Largest error [m] against a wave, at both walls, 0.05 m from them, on and off particles.
double largest_error(const Particles& particles, const Wave& wave, double shift = 0) {
  double error = 0;
  for (double x : {0.0, 0.003, 0.05, 0.17, 0.31, 0.4999, 0.62, 0.745, 0.88, 0.95, 0.991, 1.0}) {
    const double difference = gauge(particles, x) - (wave.elevation(x) + shift);
    error = std::max(error, std::abs(difference));
  }
  return error;
}

constexpr double tolerance = 0.02;  // of a particle spacing: 4 % of a wave of half a spacing

TEST(FreeSurfaceGauge, ReadsZeroOnTheStillLattice) {
  const Wave none{.mode = 1, .amplitude = 0};
  for (double spacing : {0.02, 0.01, 0.0102})
    EXPECT_LE(largest_error(waved_lattice(none, spacing, spacing, 0), none), 1e-3 * spacing);
}

class GaugeOnAWave : public testing::TestWithParam<std::tuple<double, int, double>> {
 protected:
  const double spacing = std::get<0>(GetParam());
  const Wave wave{.mode = std::get<1>(GetParam()), .amplitude = std::get<2>(GetParam()) * spacing};
};

TEST_P(GaugeOnAWave, ErrsByLessThanTwoPerCentOfAParticleSpacing) {
  EXPECT_LE(largest_error(waved_lattice(wave, spacing, spacing, 0), wave), tolerance * spacing);
}

TEST_P(GaugeOnAWave, ErrsAsLittleUnderTwoSpacings) {
  EXPECT_LE(largest_error(waved_lattice(wave, spacing, spacing / 2, 0), wave), tolerance * spacing);
}

TEST_P(GaugeOnAWave, ErrsAsLittleWhereParticlesAreDisordered) {
  const double disorder = 0.025 * spacing;
  EXPECT_LE(largest_error(waved_lattice(wave, spacing, spacing, disorder), wave),
            tolerance * spacing);
}

INSTANTIATE_TEST_SUITE_P(SpacingModeAmplitude, GaugeOnAWave,
                         testing::Combine(testing::Values(0.01, 0.02), testing::Values(1, 2, 3),
                                          testing::Values(0.1, 0.5, 1.0)));

// The error that the window does not average out grows as the square of the disorder.
TEST(FreeSurfaceGauge, ErrsByLessThanFivePerCentOfASpacingUnderStrongerDisorder) {
  for (double spacing : {0.02, 0.01}) {
    const Wave wave{.mode = 1, .amplitude = 0.5 * spacing};
    EXPECT_LE(largest_error(waved_lattice(wave, spacing, spacing, 0.05 * spacing), wave),
              0.05 * spacing);
  }
}

// Waves of 8 cm from trough to crest: the columns are 10 % narrower under a crest than at rest, so
// that the window is no whole number of them wide.
TEST(FreeSurfaceGauge, ErrsByLessThanFivePerCentOfASpacingOnSteepWaves) {
  for (int mode : {1, 2, 3}) {
    const Wave wave{.mode = mode, .amplitude = 0.04};
    EXPECT_LE(largest_error(waved_lattice(wave, 0.02, 0.02, 0), wave), 0.05 * 0.02) << mode;
  }
}

TEST(FreeSurfaceGauge, SeesASurfaceThatIsFivePerCentTooHigh) {
  const Wave wave{.mode = 1, .amplitude = 0.01}, scaled{.mode = 1, .amplitude = 0.0105};
  EXPECT_GT(largest_error(waved_lattice(scaled, 0.01, 0.01, 0.025 * 0.01), wave), tolerance * 0.01);
}

TEST(FreeSurfaceGauge, SeesASurfaceThatIsATenthOfASpacingOff) {
  const Wave wave{.mode = 1, .amplitude = 0.01};
  const Particles particles = waved_lattice(wave, 0.01, 0.01, 0.025 * 0.01);
  EXPECT_GT(largest_error(particles, wave, 0.1 * 0.01), tolerance * 0.01);
  EXPECT_GT(largest_error(particles, wave, -0.1 * 0.01), tolerance * 0.01);
}

// As from a surface one row too low.
TEST(FreeSurfaceGauge, SeesAMissingRowOfParticles) {
  const Wave none{.mode = 1, .amplitude = 0};
  Particles particles = waved_lattice(none, 0.01, 0.01, 0);
  for (std::size_t i = 0; i < particles.size(); ++i)
    if (particles.z[i] > 0.34) particles.mass[i] = 0;
  for (double x : {0.0, 0.05, 0.5, 1.0}) EXPECT_NEAR(gauge(particles, x), -0.01, 1e-6) << x;
}

// A plate one spacing thick with liquid on its left alone.
TEST(FreeSurfaceGauge, MeasuresTheDepthOnItsOwnSideOfAPlate) {
  Particles particles = waved_lattice({.mode = 1, .amplitude = 0}, 0.01, 0.01, 0);
  for (std::size_t i = 0; i < particles.size(); ++i)
    if (particles.x[i] > 0.5) particles.mass[i] = 0;
  const LineOfSight sight({{0.5, 0.51, -0.03, 1}});
  for (const double x : {0.48, 0.495, 0.5})
    EXPECT_NEAR(surface_elevation(particles, 1, 0.35, x, sight), 0, 1e-6) << x;
  EXPECT_NEAR(surface_elevation(particles, 1, 0.35, 0.515, sight), -0.35, 1e-12);
  EXPECT_LT(gauge(particles, 0.495), -0.05) << "without the plate";
}

TEST(HighestSurface, IsTheUpperEdgeOfTheHighestParticleNearby) {
  Particles particles = waved_lattice({.mode = 1, .amplitude = 0}, 0.01, 0.01, 0);
  EXPECT_NEAR(highest_surface(particles, 0.35, 0.95), 0, 1e-12);
  particles.x[7] = 0.955;
  particles.z[7] = 0.6;
  EXPECT_NEAR(highest_surface(particles, 0.35, 0.95), 0.255, 1e-12);
  EXPECT_NEAR(highest_surface(particles, 0.35, 0.97), 0, 1e-12);
}

}  // namespace
}  // namespace slosh::sph::free_surface_gauge_test

#include "sph/start/initial_lattice.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "sph/scheme.hpp"
#include "sph/schemes.hpp"
#include "sph/start/initial_surface.hpp"
#include "sph/terms/equation_of_state.hpp"
#include "sph/tests/surging_scene.hpp"
#include "sph/walls/obstacle_contact.hpp"
#include "verification/tests/messages.hpp"

namespace slosh::sph::initial_lattice_test {
namespace {

const Tait state(1000, 18.8);
const auto incompressible = [](double) { return 1000.0; };
const auto water = [](double pressure) { return state.density(pressure); };

double volume(const Particles& particles) {
  double sum = 0;
  for (std::size_t i = 0; i < particles.size(); ++i)
    sum += particles.mass[i] / particles.density[i];
  return sum;
}

TEST(InitialLattice, FillsTheDepthExactly) {
  for (double spacing : {0.05, 0.025, 0.02, 0.0101, 0.01})
    EXPECT_NEAR(volume(initial_lattice(still_scene(spacing, 0), water)), 0.35, 1e-12) << spacing;
}

TEST(InitialLattice, HasThePapers900ParticlesAtTwoCentimetres) {
  EXPECT_EQ(initial_lattice(still_scene(0.02, 0), water).size(), 900);
}

TEST(InitialLattice, CarriesTheHydrostaticPressure) {
  const Particles particles = initial_lattice(still_scene(0.02, 0), water);
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const double pressure = 1000 * 9.81 * (0.35 - particles.z[i]);
    EXPECT_NEAR(state.pressure(particles.density[i]), pressure, 1e-7);
  }
}

TEST(InitialLattice, StandsHalfACellOffTheWallsAndTheSurface) {
  for (double spacing : {0.02, 0.01}) {
    const Particles p = initial_lattice(still_scene(spacing, 0), water);
    const auto [left, right] = std::minmax_element(p.x.begin(), p.x.end());
    const auto [lowest, highest] = std::minmax_element(p.z.begin(), p.z.end());
    EXPECT_NEAR(*left, 1 - *right, 1e-14);
    EXPECT_NEAR(*left, 0.5 * spacing, 1e-14);
    EXPECT_NEAR(*lowest, 0.35 - *highest, 1e-14);
    // 18 rows in place of 17.5 at two centimetres.
    EXPECT_NEAR(*lowest, spacing == 0.02 ? 0.35 / 36 : 0.005, 1e-14);
  }
}

TEST(InitialLattice, KnowsItsFlattestCell) {
  EXPECT_NEAR(flattest_cell(lattice_of_volumes(still_scene(0.01, 0))), 1, 1e-12);
  EXPECT_NEAR(flattest_cell(lattice_of_volumes(still_scene(0.02, 0))), 17.5 / 18, 1e-12);
}

TEST(InitialLattice, KnowsTheMeanDepthOfItsLiquid) {
  const auto depth_of = [](const Scene& scene) {
    return mean_depth(lattice_of_volumes(scene), scene);
  };
  for (double spacing : {0.02, 0.01})
    EXPECT_NEAR(depth_of(still_scene(spacing, 0)), 0.175, 1e-14) << spacing;
  // A triangle with its tip at the bottom: its centroid is at two thirds of the height.
  Scene triangle = still_scene(0.01, 0);
  triangle.outline = {{0.5, 0}, {1, 1}, {0, 1}};
  EXPECT_NEAR(depth_of(triangle), 0.35 / 3, 1e-4);
}

TEST(InitialLattice, MayBeTurnedAndKeepsItsVolume) {
  Scene scene = still_scene(0.01, 0);
  scene.start_rotation = 0.35;
  const Particles p = initial_lattice(scene, water);
  EXPECT_NEAR(volume(p), 0.35, 1e-12);
  EXPECT_NEAR(static_cast<double>(p.size()), 3500, 0.01 * 3500);
  const auto [left, right] = std::minmax_element(p.x.begin(), p.x.end());
  const auto [lowest, highest] = std::minmax_element(p.z.begin(), p.z.end());
  EXPECT_GT(*left, 0);
  EXPECT_LT(*left, 0.01);
  EXPECT_LT(*right, 1);
  EXPECT_GT(*lowest, 0);
  EXPECT_LT(*highest, 0.35);
  EXPECT_GT(*highest, 0.34);
  // The nearest neighbour of a particle in the middle lies one spacing away along a turned row.
  std::size_t middle = 0;
  const auto from = [&](std::size_t i, double x, double z) {
    return std::hypot(p.x[i] - x, p.z[i] - z);
  };
  for (std::size_t i = 1; i < p.size(); ++i)
    if (from(i, 0.5, 0.175) < from(middle, 0.5, 0.175)) middle = i;
  const double along_x = p.x[middle] + 0.01 * std::cos(0.35),
               along_z = p.z[middle] + 0.01 * std::sin(0.35);
  double nearest = 1;
  for (std::size_t i = 0; i < p.size(); ++i) nearest = std::min(nearest, from(i, along_x, along_z));
  EXPECT_LT(nearest, 1e-12);
}

TEST(InitialLattice, LaysTheFinerSpacingAtTheSurface) {
  Scene scene = still_scene(0.02, 0);
  scene.surface_particle_spacing = 0.01;
  const Particles particles = initial_lattice(scene, water);
  // 12 coarse layers up to 0.24 m and 11 fine ones above.
  ASSERT_EQ(particles.size(), 12 * 50 + 11 * 100);
  EXPECT_NEAR(volume(particles), 0.35, 1e-12);
  for (std::size_t i = 0; i < particles.size(); ++i) {
    EXPECT_NEAR(particles.spacing[i], particles.z[i] < 0.24 ? 0.02 : 0.01, 1e-14);
    const double pressure = 1000 * 9.81 * (0.35 - particles.z[i]);
    EXPECT_NEAR(state.pressure(particles.density[i]), pressure, 1e-7);
  }
}

TEST(InitialLattice, RefusesASpacingThatWouldStretchItByMoreThanFivePerCent) {
  EXPECT_THROW(initial_lattice(still_scene(0.08, 0), water), std::invalid_argument);   // 12.5 x 4.4
  EXPECT_THROW(initial_lattice(still_scene(0.125, 0), water), std::invalid_argument);  // 8 x 2.8
  EXPECT_NO_THROW(initial_lattice(still_scene(0.0365, 0), water));                     // 27.4 x 9.6
  for (double spacing : {0.0, -0.02, 3.0, std::nan("")})
    EXPECT_THROW(initial_lattice(still_scene(spacing, 0), water), std::invalid_argument) << spacing;
}

TEST(PerturbRandomly, MovesEveryParticleByUpToItsShareAsTheSeedHasIt) {
  const Particles lattice = initial_lattice(still_scene(0.02, 0), water);
  Particles one = lattice, same = lattice, other = lattice, none = lattice;
  perturb_randomly(one, 0.1, 1);
  perturb_randomly(same, 0.1, 1);
  perturb_randomly(other, 0.1, 2);
  perturb_randomly(none, 0, 1);
  EXPECT_EQ(one.x, same.x);
  EXPECT_EQ(one.z, same.z);
  EXPECT_NE(one.x, other.x);
  EXPECT_EQ(none.x, lattice.x);
  double farthest = 0, sum = 0;
  for (std::size_t i = 0; i < one.size(); ++i) {
    for (const double moved : {one.x[i] - lattice.x[i], one.z[i] - lattice.z[i]}) {
      farthest = std::max(farthest, std::abs(moved));
      sum += moved;
    }
  }
  EXPECT_LE(farthest, 0.1 * 0.02);
  EXPECT_GE(farthest, 0.099 * 0.02);
  // The limit is four standard deviations of the mean of 1800 numbers, uniform within +-0.002 m.
  EXPECT_LE(std::abs(sum / 1800), 4 * 0.002 / std::sqrt(3 * 1800.0));
  for (const double share : {-0.1, 0.26, std::nan("")})
    EXPECT_THROW(perturb_randomly(none, share, 1), std::invalid_argument) << share;
}

TEST(InitialLattice, RefusesASurfaceSpacingThatIsNotFinerOrLeavesNoRoom) {
  Scene scene = still_scene(0.05, 0);
  for (double surface : {0.07, 0.04, 0.0, -0.01, std::nan("")}) {
    scene.surface_particle_spacing = surface;
    EXPECT_THROW(initial_lattice(scene, water), std::invalid_argument) << surface;
  }
}

TEST(InitialLattice, FillsTheColumnOfADamAlone) {
  const Particles p = initial_lattice(dam_scene(0.025, 0), incompressible);
  ASSERT_EQ(p.size(), 8 * 16);
  EXPECT_NEAR(*std::max_element(p.x.begin(), p.x.end()), 0.2 - 0.0125, 1e-12);
  EXPECT_NEAR(*std::max_element(p.z.begin(), p.z.end()), 0.4 - 0.0125, 1e-12);
  double mass = 0;
  for (const double m : p.mass) mass += m;
  EXPECT_NEAR(mass, 1000 * 0.2 * 0.4, 1e-9);
}

TEST(InitialLattice, LeavesOutWhatObstaclesTake) {
  const Rectangle obstacle{0.4, 0.6, 0, 0.2};
  const Particles p =
      initial_lattice(with_obstacle(still_scene(0.025, 0), obstacle), incompressible);
  EXPECT_EQ(p.size(), 40 * 14 - 8 * 8);
  for (std::size_t i = 0; i < p.size(); ++i) EXPECT_FALSE(holds(obstacle, p.x[i], p.z[i]));
}

TEST(InitialLattice, RefusesAColumnThatIsNoWholeNumberOfParticlesWide) {
  Scene scene = dam_scene(0.025, 0);
  scene.column_width = 0.062;
  const std::string refusal =
      message_of<std::invalid_argument>([&] { initial_lattice(scene, incompressible); });
  for (const char* part : {"particle_spacing = 0.025 m", "expected", "column's width of 0.062 m"})
    EXPECT_TRUE(slosh::holds(refusal, part));
}

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

}  // namespace
}  // namespace slosh::sph::initial_lattice_test

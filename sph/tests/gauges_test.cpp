// What gauges of the surface, of pressure and of velocity read, and where the front is.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "sph/recording/free_surface.hpp"
#include "sph/recording/probe.hpp"
#include "sph/recording/wall_pressure_gauge.hpp"
#include "sph/start/initial_lattice.hpp"
#include "sph/terms/equation_of_state.hpp"
#include "sph/tests/surging_scene.hpp"
#include "sph/tests/waved_lattice.hpp"

namespace slosh::sph::gauges_test {
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

// By less than two per cent of a spacing, on the lattice, under two spacings and in disorder.
TEST(FreeSurfaceGauge, ErrsLittleOnWavesOfEveryLengthAndHeight) {
  for (const double spacing : {0.01, 0.02})
    for (const int mode : {1, 2, 3})
      for (const double height : {0.1, 0.5, 1.0}) {
        const Wave wave{.mode = mode, .amplitude = height * spacing};
        for (const auto& [surface_spacing, disorder] :
             {std::pair{spacing, 0.0}, {spacing / 2, 0.0}, {spacing, 0.025 * spacing}})
          EXPECT_LE(largest_error(waved_lattice(wave, spacing, surface_spacing, disorder), wave),
                    tolerance * spacing)
              << spacing << " " << mode << " " << height << " " << surface_spacing;
      }
}

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

constexpr double dp = 0.01;

// A layer of particles dp apart on the bottom from the left wall, the last one's edge at `front`.
Particles layer(double front) {
  Particles particles;
  for (double x = 0.5 * dp; x < front; x += dp) {
    particles.x.push_back(x);
    particles.z.push_back(0.5 * dp);
  }
  return particles;
}

void add(Particles& particles, double x, double z) {
  particles.x.push_back(x);
  particles.z.push_back(z);
}

double front(const Particles& particles) { return front_position(particles, dp); }

TEST(FrontPosition, IsTheEdgeOfAColumnAtRest) {
  Particles column = layer(0.2);
  for (double x = 0.5 * dp; x < 0.2; x += dp) add(column, x, 1.5 * dp);
  EXPECT_NEAR(front(column), 0.2, 1e-12);
}

TEST(FrontPosition, FollowsATongueUntilItIsHalfASpacingDeep) {
  Particles tongue = layer(0.2);
  for (double gap : {1.2, 1.5, 1.9}) add(tongue, tongue.x.back() + gap * dp, 0.5 * dp);
  const double last = tongue.x.back();
  add(tongue, last + 2.1 * dp, 0.5 * dp);
  EXPECT_NEAR(front(tongue), last + 0.5 * dp, 1e-12);
}

TEST(FrontPosition, TakesNoParticleThatRunsAheadForTheFront) {
  Particles liquid = layer(0.2);
  add(liquid, 0.23, 0.4 * dp);
  add(liquid, 0.31, 0.4 * dp);
  add(liquid, 0.315, 0.4 * dp);
  EXPECT_NEAR(front(liquid), 0.2, 1e-12);
}

TEST(FrontPosition, TakesNoJetAboveTheBottomForTheFront) {
  Particles liquid = layer(0.2);
  for (double x = 0.205; x < 0.3; x += dp) add(liquid, x, 2.1 * dp);
  EXPECT_NEAR(front(liquid), 0.2, 1e-12);
}

TEST(FrontPosition, PassesAGapOfTheLowestLayerUnderLiquid) {
  Particles liquid = layer(0.1);
  for (double x = 0.095; x < 0.2; x += dp) add(liquid, x, 1.5 * dp);
  EXPECT_NEAR(front(liquid), 0.2, 1e-12);
}

TEST(FrontPosition, DoesNotDependOnTheOrderOfTheParticles) {
  Particles forward = layer(0.2), backward;
  for (std::size_t i = forward.size(); i-- > 0;) add(backward, forward.x[i], forward.z[i]);
  EXPECT_EQ(front(backward), front(forward));
}

TEST(FrontPosition, IsTheWallWhereNothingStandsBeforeIt) {
  EXPECT_EQ(front(Particles{}), 0);
  Particles liquid;
  add(liquid, 0.1, 0.5 * dp);
  EXPECT_EQ(front(liquid), 0);
}

const Tait state(1000, 18.5);
double pressure_at(double density) { return state.pressure(density); }

Particles still_water(const Scene& scene) {
  return initial_lattice(scene, [](double pressure) { return state.density(pressure); });
}

double read(const Scene& scene, const Particles& p, const PressureGauge& gauge, double t = 0) {
  return wall_pressure(p, gauge, scene, TankMotion(scene, t), pressure_at);
}

// The liquid's own density, 0.3 % above the rest density, makes the rest.
TEST(WallPressure, IsHydrostaticOnEveryWallOfStillWater) {
  const Scene scene = still_scene(0.01, 0);
  const Particles p = still_water(scene);
  const double unit = 1000 * 9.81;
  for (const double z : {0.003, 0.1, 0.2, 0.3}) {
    EXPECT_NEAR(read(scene, p, {"a", Wall::left, z, 0}), unit * (0.35 - z), 2e-3 * unit * 0.35)
        << z;
    EXPECT_NEAR(read(scene, p, {"a", Wall::right, z, 0}), unit * (0.35 - z), 2e-3 * unit * 0.35);
  }
  EXPECT_NEAR(read(scene, p, {"a", Wall::bottom, 0.4, 0.05}), unit * 0.35, 2e-3 * unit * 0.35);
}

// Right of a plate one spacing thick the liquid is compressed.
TEST(WallPressure, DoesNotLookThroughAPlate) {
  Scene scene = still_scene(0.01, 0);
  scene.obstacles = {{0.5, 0.51, 0, 0.2}};
  Particles p = still_water(scene);
  for (std::size_t i = 0; i < p.size(); ++i)
    if (p.x[i] > 0.505) p.density[i] *= 1.1;
  const double still = 1000 * 9.81 * 0.35;
  EXPECT_NEAR(read(scene, p, {"a", Wall::bottom, 0.495, 0}), still, 0.01 * still);
  EXPECT_GT(read(scene, p, {"a", Wall::bottom, 0.515, 0}), 5 * still);
  scene.obstacles.clear();  // it can fail
  EXPECT_GT(read(scene, p, {"a", Wall::bottom, 0.495, 0}), 1.1 * still);
}

TEST(WallPressure, IsTheMeanOverASensorThatIsPartlyDry) {
  const Scene scene = still_scene(0.01, 0);
  const Particles p = still_water(scene);
  // From 0.25 to 0.45 m: half of it under water, at 0.05 m on average.
  EXPECT_NEAR(read(scene, p, {"a", Wall::left, 0.35, 0.2}), 0.5 * 1000 * 9.81 * 0.05, 25);
  EXPECT_EQ(read(scene, p, {"a", Wall::left, 0.5, 0.02}), 0);
}

TEST(WallPressure, FollowsTheWallsAccelerationAlongItsNormal) {
  // A liquid that rests in a tank of constant acceleration a: p = rho g depth - rho a x.
  Scene scene = still_scene(0.01, 0);
  scene.acceleration = [](double) { return 2.0; };
  Particles p = still_water(scene);
  for (std::size_t i = 0; i < p.size(); ++i)
    p.density[i] = state.density(1000 * (9.81 * (0.35 - p.z[i]) + 2.0 * (1 - p.x[i])));
  EXPECT_NEAR(read(scene, p, {"a", Wall::left, 0.1, 0}), 1000 * (9.81 * 0.25 + 2), 10);
  EXPECT_NEAR(read(scene, p, {"a", Wall::right, 0.1, 0}), 1000 * 9.81 * 0.25, 10);
}

TEST(WallPressure, RefusesASensorThatIsNotWhollyOnItsWall) {
  const Scene scene = still_scene(0.01, 0);
  EXPECT_NO_THROW(require_on_wall({"a", Wall::left, 0.01, 0.02}, scene));
  for (const PressureGauge& gauge :
       {PressureGauge{"a", Wall::left, -0.1, 0}, PressureGauge{"a", Wall::left, 0.01, 0.03},
        PressureGauge{"a", Wall::right, 1.1, 0}, PressureGauge{"a", Wall::bottom, 0.5, -0.01},
        PressureGauge{"a", Wall::bottom, std::nan(""), 0}})
    EXPECT_THROW(require_on_wall(gauge, scene), std::invalid_argument);
}

Probed read(const Scene& scene, const Particles& p, double x, double z, double t = 0) {
  return probed(p, {"a", x, z}, scene, TankMotion(scene, t), pressure_at);
}

// The particles are displaced at random, and probes stand in the middle, at the walls and in
// corners.
TEST(Probe, ReadsALinearVelocityWithoutErrorOnADisorderedLiquid) {
  const Scene scene = still_scene(0.02, 0);
  Particles p = still_water(scene);
  perturb_randomly(p, 0.2, 1);
  const auto u = [](double x, double z) { return 0.3 + 0.7 * x - 0.2 * z; };
  const auto w = [](double x, double z) { return -0.1 - 0.4 * x - 0.7 * z; };
  for (std::size_t i = 0; i < p.size(); ++i) {
    p.velocity_x[i] = u(p.x[i], p.z[i]);
    p.velocity_z[i] = w(p.x[i], p.z[i]);
  }
  for (const auto& [x, z] :
       {std::pair{0.5, 0.2}, {0.0, 0.1}, {1.0, 0.2}, {0.37, 0.0}, {0.0, 0.0}, {0.6, 0.34}}) {
    const Probed found = read(scene, p, x, z);
    EXPECT_NEAR(found.velocity.x, u(x, z), 1e-12) << x << " " << z;
    EXPECT_NEAR(found.velocity.z, w(x, z), 1e-12) << x << " " << z;
  }
}

// A wave of 40 spacings loses (k r)^2 / 2 times the kernel's second moment, of about a tenth of the
// square of its radius: 1 %.
TEST(Probe, SmoothsAShortWaveByTheKernelsSecondMoment) {
  const Scene scene = still_scene(0.01, 0);
  Particles p = still_water(scene);
  const double k = 2 * std::numbers::pi / 0.4;
  for (std::size_t i = 0; i < p.size(); ++i) p.velocity_x[i] = std::cos(k * (p.x[i] - 0.5));
  const double found = read(scene, p, 0.5, 0.175).velocity.x;
  EXPECT_LT(found, 1);
  EXPECT_NEAR(found, 1, 0.02);
}

// Left and right of a plate one spacing thick the velocities are opposite.
TEST(Probe, DoesNotLookThroughAPlate) {
  Scene scene = still_scene(0.01, 0);
  scene.obstacles = {{0.5, 0.51, 0, 0.2}};
  Particles p = still_water(scene);
  for (std::size_t i = 0; i < p.size(); ++i) p.velocity_x[i] = p.x[i] < 0.505 ? -1 : 1;
  EXPECT_NEAR(read(scene, p, 0.495, 0.1).velocity.x, -1, 1e-12);
  EXPECT_NEAR(read(scene, p, 0.515, 0.1).velocity.x, 1, 1e-12);
  scene.obstacles.clear();  // it can fail
  EXPECT_GT(std::abs(read(scene, p, 0.495, 0.1).velocity.x + 1), 0.1);
}

TEST(Probe, ReadsTheHydrostaticPressure) {
  const Scene scene = still_scene(0.01, 0);
  const Particles p = still_water(scene);
  for (const auto& [x, z] : {std::pair{0.5, 0.2}, {0.0, 0.05}, {0.9, 0.3}, {0.3, 0.0}})
    EXPECT_NEAR(read(scene, p, x, z).pressure, 9810 * (0.35 - z), 2e-3 * 9810 * 0.35)
        << x << " " << z;
}

TEST(Probe, IsDryAboveTheSurfaceAlsoBesideAWall) {
  const Scene scene = still_scene(0.01, 0);
  Particles p = still_water(scene);
  for (double& velocity : p.velocity_x) velocity = 1;
  for (const double x : {0.0, 0.5, 1.0}) {
    EXPECT_EQ(read(scene, p, x, 0.356).velocity.x, 0) << x;
    EXPECT_EQ(read(scene, p, x, 0.356).pressure, 0) << x;
    EXPECT_NEAR(read(scene, p, x, 0.344).velocity.x, 1, 1e-12) << x;
    EXPECT_EQ(read(scene, p, x, 0.9).velocity.x, 0) << x;
  }
}

// A liquid that moves with a tank that surges and rolls is at rest in it.
TEST(Probe, MovesWithTheTank) {
  const Scene scene = surging_and_rolling_scene(0.02, 0);
  Particles p = still_water(scene);
  const double t = 0.3;
  const TankMotion motion(scene, t);
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Vector2 tank = motion.velocity(p.x[i], p.z[i]);
    p.velocity_x[i] = tank.x;
    p.velocity_z[i] = tank.z;
  }
  EXPECT_GT(std::abs(motion.velocity(0.4, 0.1).x), 0.005);
  const Probed found = read(scene, p, 0.4, 0.1, t);
  EXPECT_NEAR(found.velocity.x, 0, 1e-14);
  EXPECT_NEAR(found.velocity.z, 0, 1e-14);
}

}  // namespace
}  // namespace slosh::sph::gauges_test

#include "sph/recording/probe.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "sph/start/initial_lattice.hpp"
#include "sph/terms/equation_of_state.hpp"
#include "sph/tests/rolling_scene.hpp"

namespace slosh::sph::probe_test {
namespace {

const Tait state(1000, 18.5);
double pressure_at(double density) { return state.pressure(density); }

Particles still_water(const Scene& scene) {
  return initial_lattice(scene, [](double pressure) { return state.density(pressure); });
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

TEST(Probe, RefusesAPlaceOutsideTheTank) {
  Scene scene = still_scene(0.05, 0.01);
  scene.probes = {{"low", 0.5, -0.1}};
  EXPECT_THROW(run("recommended", scene, {}), std::invalid_argument);
  scene.probes = {{"far", 1.1, 0.1}};
  EXPECT_THROW(run("recommended", scene, {}), std::invalid_argument);
  scene.probes = {{"none", std::nan(""), 0.1}};
  EXPECT_THROW(run("recommended", scene, {}), std::invalid_argument);
}

}  // namespace
}  // namespace slosh::sph::probe_test

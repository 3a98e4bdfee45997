#include "sph/recording/wall_pressure_gauge.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "sph/start/initial_lattice.hpp"
#include "sph/terms/equation_of_state.hpp"
#include "sph/tests/rolling_scene.hpp"

namespace slosh::sph::wall_pressure_gauge_test {
namespace {

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

// At the start of a run whose liquid has not moved yet the weight is what the walls bear.
TEST(Forces, BearTheWeightOfALiquidThatRestsInARollingTankAndItsMomentAboutTheAxis) {
  Scene scene = surging_and_rolling_scene(0.02, 0.02);
  for (auto* function : {&scene.displacement, &scene.velocity, &scene.acceleration})
    *function = [](double) { return 0.0; };
  scene.roll = no_roll();
  scene.roll->axis_x = 0.3;
  for (const char* scheme : {"recommended", "li2010", "delta_sph"}) {
    const RunOutput output = run(scheme, scene, {});
    const double weight = 1000 * 9.81 * 0.8 * 0.24;
    EXPECT_NEAR(output.force_z.value.back(), -weight, 0.03 * weight) << scheme;
    EXPECT_NEAR(output.force_x.value.back(), 0, 0.002 * weight) << scheme;
    EXPECT_NEAR(output.moment.value.back(), -weight * 0.1, 0.03 * weight * 0.1) << scheme;
  }
}

}  // namespace
}  // namespace slosh::sph::wall_pressure_gauge_test

#include "sph/recording/still_water.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "sph/start/initial_lattice.hpp"
#include "sph/terms/equation_of_state.hpp"
#include "sph/tests/surging_scene.hpp"

namespace slosh::sph::still_water_test {
namespace {

constexpr double dp = 0.025, fill_depth = 0.35, rho = 1000, g = 9.81;
const Tait state(rho, 18.5);

class StillWaterSeries : public testing::Test {
 protected:
  const Scene scene = still_scene(dp, 0);
  const Particles start =
      initial_lattice(scene, [](double pressure) { return state.density(pressure); });
  const StillWater still_water{scene, start,
                               [](double density) { return state.pressure(density); }};
  Particles now = start;

  double value(const std::string& name) {
    std::vector<RecordedSeries> series;
    still_water.record(now, 1.5, series);
    for (const RecordedSeries& one : series)
      if (one.name == name) return one.history.value.back();
    ADD_FAILURE() << "no series " << name;
    return std::nan("");
  }

  // The particle in this column and row of the lattice.
  static std::size_t at(int column, int row) { return row * 40 + column; }
};

TEST_F(StillWaterSeries, AreZeroOnTheStillLattice) {
  std::vector<RecordedSeries> series;
  still_water.record(now, 0, series);
  still_water.record(now, 0.5, series);
  ASSERT_EQ(series.size(), 4);
  for (const RecordedSeries& one : series) {
    EXPECT_EQ(one.unit, "1");
    EXPECT_EQ(one.history.time, (std::vector<double>{0, 0.5}));
    for (const double value : one.history.value) EXPECT_NEAR(value, 0, 1e-11) << one.name;
  }
}

TEST_F(StillWaterSeries, KnowTheRmsErrorOfThePressure) {
  // 50 Pa on half of the particles.
  for (std::size_t i = 0; i < now.size(); i += 2)
    now.density[i] = state.density(rho * g * (fill_depth - now.z[i]) + 50);
  EXPECT_NEAR(value("hydrostatic_pressure_error"), 50 / std::sqrt(2) / (rho * g * fill_depth),
              1e-10);
}

TEST_F(StillWaterSeries, MeasureThePressureAtTheParticlesOwnHeight) {
  for (double& z : now.z) z += 0.001;  // the liquid carries its pressure with it
  EXPECT_NEAR(value("hydrostatic_pressure_error"), 0.001 / fill_depth, 1e-9);
}

TEST_F(StillWaterSeries, KnowTheKineticEnergy) {
  for (std::size_t i = 0; i < now.size(); ++i) {
    now.mass[i] = rho * dp * dp;
    now.velocity_x[i] = 0.03;
    now.velocity_z[i] = -0.04;
  }
  // 0.05^2 / 2 of rho fill_depth length over rho g fill_depth^2 / 2 times length.
  EXPECT_NEAR(value("kinetic_over_potential_energy"), 0.0025 / (g * fill_depth), 1e-12);
}

TEST_F(StillWaterSeries, KnowTheVolume) {
  for (double& density : now.density) density /= 1.004;
  EXPECT_NEAR(value("volume_drift"), 0.004, 1e-12);
  for (double& mass : now.mass) mass *= 0.5;
  EXPECT_NEAR(value("volume_drift"), 0.502 - 1, 1e-12);
}

TEST_F(StillWaterSeries, SeeAGapAtTheBottomOrAtASide) {
  // Both columns of a window of the bottom.
  for (const int column : {10, 11}) now.z[at(column, 0)] += 0.3 * dp;
  EXPECT_NEAR(value("wall_gap"), 0.3, 1e-9);
  now = start;
  for (const int row : {4, 5}) now.x[at(0, row)] += 0.2 * dp;
  EXPECT_NEAR(value("wall_gap"), 0.2, 1e-9);
  now = start;
  for (const int row : {4, 5}) now.x[at(39, row)] -= 0.25 * dp;
  EXPECT_NEAR(value("wall_gap"), 0.25, 1e-9);
}

TEST_F(StillWaterSeries, DoNotTakeASingleParticlesPlaceForAGap) {
  now.z[at(10, 0)] += 0.3 * dp;
  EXPECT_NEAR(value("wall_gap"), 0, 1e-9);
  now = start;
  for (const int row : {12, 13}) now.x[at(0, row)] += 0.3 * dp;  // above 0.8 of the depth
  EXPECT_NEAR(value("wall_gap"), 0, 1e-9);
}

TEST_F(StillWaterSeries, SeeAWallWithoutAnyParticle) {
  for (std::size_t i = 0; i < now.size(); ++i)
    if (now.x[i] < 0.3) now.x[i] = 0.3;
  EXPECT_GT(value("wall_gap"), 10);
}

TEST_F(StillWaterSeries, SeeNoGapWhereAnObstacleStands) {
  Scene with_obstacle = scene;
  with_obstacle.obstacles = {{0.4, 0.6, 0, 0.2}};
  now = initial_lattice(with_obstacle, [](double pressure) { return state.density(pressure); });
  const StillWater around(with_obstacle, now, [](double d) { return state.pressure(d); });
  std::vector<RecordedSeries> series;
  around.record(now, 0, series);
  for (const RecordedSeries& one : series) EXPECT_NEAR(one.history.value[0], 0, 1e-11) << one.name;
}

}  // namespace
}  // namespace slosh::sph::still_water_test

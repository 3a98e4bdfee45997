// The series that tell whether a run is sound, and how still its still water is.
#include "sph/recording/soundness.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "sph/recording/still_water.hpp"
#include "sph/scheme.hpp"
#include "sph/schemes.hpp"
#include "sph/simulation.hpp"
#include "sph/start/initial_lattice.hpp"
#include "sph/terms/equation_of_state.hpp"
#include "sph/tests/surging_scene.hpp"

namespace slosh::sph::soundness_test {
namespace {

constexpr double dp = 0.01;
// How many particles wide and high a tank is in which most of them have a wall within their kernel,
// and one in which most have none.
constexpr int narrow = 10, wide = 30;

// A tank that moves along at 0.5 m/s.
Scene full_tank(int cells) {
  Scene scene = carried_scene(dp, 0.1, 0.5);
  scene.tank_length = scene.tank_height = scene.fill_depth = cells * dp;
  scene.gauges.clear();
  return scene;
}

// Fills the tank with a liquid of this density that moves with it.
Particles lattice(int cells, double density) {
  Particles p;
  for (int row = 0; row < cells; ++row)
    for (int column = 0; column < cells; ++column) {
      p.x.push_back((column + 0.5) * dp);
      p.z.push_back((row + 0.5) * dp);
      p.velocity_x.push_back(0.5);
      p.velocity_z.push_back(0);
      p.density.push_back(density);
      p.mass.push_back(density * dp * dp);
      p.spacing.push_back(dp);
    }
  return p;
}

template <class Choice>
class SoundnessSeries : public testing::Test {
 protected:
  const Scene scene = full_tank(narrow);
  const Scheme<Choice> scheme{scene};
  Liquid liquid{scene, method_of(scheme), lattice(narrow, scheme.setting.rest_density)};

  // The value at the start of a run that starts from the liquid's present state.
  double value(const std::string& name) {
    RunOutput output;
    Soundness().record(liquid, false, output);
    for (const RecordedSeries& one : output.soundness)
      if (one.name == name) return one.history.value.back();
    ADD_FAILURE() << "no series " << name;
    return std::nan("");
  }
};
// Walls of mirror, ghost and dynamic particles, and weights of volumes and of masses.
using Choices = testing::Types<Recommended, WithGhostWalls, DeltaSph, Li2010, Li2010TwoSpacings,
                               Zhao2021Moving>;
TYPED_TEST_SUITE(SoundnessSeries, Choices);

TYPED_TEST(SoundnessSeries, AreZeroOfALatticeThatMovesWithItsTank) {
  for (const char* name : {"mach_number", "density_error", "tension_share"})
    EXPECT_NEAR(this->value(name), 0, 1e-12) << name;
}

TYPED_TEST(SoundnessSeries, KnowTheSpeedOfABlockThatMovesThroughItsTank) {
  for (double& u : this->liquid.particles.velocity_x) u += 0.03;
  for (double& w : this->liquid.particles.velocity_z) w = -0.04;
  EXPECT_NEAR(this->value("mach_number"), 0.05 / this->scheme.setting.speed_of_sound, 1e-12);
}

TYPED_TEST(SoundnessSeries, KnowTheLargestErrorOfTheDensityAndTheParticlesInTension) {
  Array<double>& density = this->liquid.particles.density;
  const double rest = this->scheme.setting.rest_density;
  for (std::size_t i = 0; i < density.size(); i += 4) density[i] = 0.99 * rest;
  density[2] = 1.02 * rest;
  EXPECT_NEAR(this->value("density_error"), 0.02, 1e-12);
  EXPECT_NEAR(this->value("tension_share"), 0.25, 1e-12);
}

// The walls complete the sums: at a bare edge they would be half as large.
TYPED_TEST(SoundnessSeries, StandOnAKernelSumOfOne) {
  EXPECT_NEAR(this->liquid.median_kernel_sum(), 1, 0.01);
}

// The particles draw together towards a corner and keep their masses and densities, so that the sum
// of their volumes m / rho does not change. The packing is measured at every tenth sample.
TYPED_TEST(SoundnessSeries, SeeParticlesThatComeCloserThanTheirVolumesAllow) {
  const Scene scene = full_tank(wide);
  const Scheme<TypeParam> scheme(scene);
  Liquid liquid(scene, method_of(scheme), lattice(wide, scheme.setting.rest_density));
  Soundness soundness;
  RunOutput output;
  for (int sample = 0; sample < 10; ++sample) soundness.record(liquid, false, output);
  EXPECT_EQ(output.packing_drift.value, std::vector<double>{0});
  constexpr double scale = 0.97;
  for (double& x : liquid.particles.x) x *= scale;
  for (double& z : liquid.particles.z) z *= scale;
  liquid.forget_neighbours();
  liquid.renew_neighbours(0);
  soundness.record(liquid, false, output);
  ASSERT_EQ(output.packing_drift.value.size(), 2);
  EXPECT_NEAR(output.packing_drift.value[1], 1 / (scale * scale) - 1, 0.003);
}

TYPED_TEST(SoundnessSeries, LeaveTheNextStepAsItIs) {
  Liquid other(this->scene, method_of(this->scheme),
               lattice(narrow, this->scheme.setting.rest_density));
  this->value("mach_number");
  for (auto* liquid : {&this->liquid, &other})
    typename TypeParam::Integrator().advance(*liquid, 1e-4);
  EXPECT_EQ(this->liquid.particles.velocity_z, other.particles.velocity_z);
  EXPECT_EQ(this->liquid.particles.z, other.particles.z);
  EXPECT_EQ(this->liquid.particles.density, other.particles.density);
}

TEST(SoundnessOfARun, IsRecordedAtItsSamplesAndItsLargestValuesAreDiagnostics) {
  const RunOutput output = run("recommended", surging_scene(0.05, 0.2), {});
  const auto largest = [&](const History& history) {
    double result = 0;
    for (const double value : history.value) result = std::max(result, std::abs(value));
    return result;
  };
  std::vector<std::string> names;
  for (const RecordedSeries& one : output.soundness) {
    names.push_back(one.name);
    EXPECT_EQ(one.unit, "1");
    EXPECT_EQ(one.history.time, output.kinetic_energy.time) << one.name;
    EXPECT_EQ(output.diagnostics.at("largest_" + one.name), largest(one.history));
  }
  EXPECT_EQ(names, (std::vector<std::string>{"mach_number", "density_error", "tension_share"}));
  EXPECT_EQ(output.packing_drift.time, (std::vector<double>{0, 10 * 0.01, 20 * 0.01}));
  EXPECT_EQ(output.diagnostics.at("largest_packing_drift"), largest(output.packing_drift));
  EXPECT_GT(largest(output.soundness[0].history), 0);
  EXPECT_GT(largest(output.packing_drift), 0);
}

TEST(SoundnessOfARun, HasThePackingOfItsLastSample) {
  const RunOutput output = run("recommended", surging_scene(0.05, 0.13), {});
  EXPECT_EQ(output.packing_drift.time, (std::vector<double>{0, 10 * 0.01, 13 * 0.01}));
}

constexpr double still_dp = 0.025, fill_depth = 0.35, rho = 1000, g = 9.81;
const Tait state(rho, 18.5);

class StillWaterSeries : public testing::Test {
 protected:
  const Scene scene = still_scene(still_dp, 0);
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
    now.mass[i] = rho * still_dp * still_dp;
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
  for (const int column : {10, 11}) now.z[at(column, 0)] += 0.3 * still_dp;
  EXPECT_NEAR(value("wall_gap"), 0.3, 1e-9);
  now = start;
  for (const int row : {4, 5}) now.x[at(0, row)] += 0.2 * still_dp;
  EXPECT_NEAR(value("wall_gap"), 0.2, 1e-9);
  now = start;
  for (const int row : {4, 5}) now.x[at(39, row)] -= 0.25 * still_dp;
  EXPECT_NEAR(value("wall_gap"), 0.25, 1e-9);
}

TEST_F(StillWaterSeries, DoNotTakeASingleParticlesPlaceForAGap) {
  now.z[at(10, 0)] += 0.3 * still_dp;
  EXPECT_NEAR(value("wall_gap"), 0, 1e-9);
  now = start;
  for (const int row : {12, 13}) now.x[at(0, row)] += 0.3 * still_dp;  // above 0.8 of the depth
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
}  // namespace slosh::sph::soundness_test

// Velocity and pressure at a place, and force by wall, of one small standing wave by all solvers
// that record them. Linear theory leaves out what is of the order of the wave's steepness, 1.3 %.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "openfoam_cases/run_case.hpp"
#include "verification/case/quantities.hpp"
#include "verification/runs/run_case.hpp"
#include "verification/series/windowed_series.hpp"
#include "verification/tests/sample_case.hpp"
#include "verification/tests/temporary_directory.hpp"

namespace slosh::probes_and_walls_test {
namespace {

// Potential flow differs from linear theory by the steepness alone. With 14 particles over the
// depth the wave of SPH loses up to a tenth of its height and lags by up to a tenth of a radian. In
// cells that are six times as high as the wave, that of interFoam is off by twice as much.
constexpr double of_steepness = 0.03, of_coarse_particles = 0.15, of_coarse_cells = 0.3;

constexpr double amplitude = 0.004;  // [m]

CaseDefinition standing_wave() {
  CaseDefinition definition = sample_case();
  definition.motion = {};
  definition.start = Start::tank;
  definition.initial_wave = InitialWaveDefinition{1, amplitude};
  definition.duration = 1.2;
  definition.probes = {{"middle", 0.35 * definition.tank.length, 0.2},
                       {"dry", 0.5 * definition.tank.length, definition.tank.height}};
  definition.wall_forces = {Wall::left, Wall::right, Wall::bottom, Wall::roof};
  return definition;
}

RunResult run(const CaseDefinition& definition, const decltype(RunDefinition::solver)& solver) {
  const TemporaryDirectory directory;
  return execute(definition, sample_run(solver),
                 {.work_directory = directory.path(),
                  .openfoam_templates = SLOSH_SOURCE_DIR "/openfoam_cases/sloshing_tank",
                  .key = {},
                  .command = {}},
                 [](double, double) {});
}

const RunResult& linear_theory() {
  static const RunResult result =
      run(standing_wave(), LinearRun{.modes = 0, .valid_elevation_over_depth = 0.1});
  return result;
}

double mean_of(const std::vector<double>& values) {
  double mean = 0;
  for (const double value : values) mean += value / static_cast<double>(values.size());
  return mean;
}

// Returns the rms of the difference from linear theory over that of its variation. A pressure is
// compared about its mean: the mean of interFoam's gas pressure, which is taken off, is uncertain
// by the weight of the liquid in cells that are partly gas.
double distance(const RunResult& result, const std::string& quantity) {
  const TimeSeries &of = result.at(quantity), &exact = linear_theory().at(quantity);
  std::vector<double> times = of.time;
  for (double& time : times) time = std::min(time, exact.time.back());  // rounding
  const std::vector<double> wanted = interpolate(exact, times);
  const double wanted_mean = mean_of(wanted),
               shift = quantity.starts_with("pressure") ? mean_of(of.value) - wanted_mean : 0;
  double difference = 0, variation = 0;
  for (std::size_t i = 0; i < of.time.size(); ++i) {
    difference += std::pow(of.value[i] - shift - wanted[i], 2);
    variation += std::pow(wanted[i] - wanted_mean, 2);
  }
  return std::sqrt(difference / variation);
}

void expect_linear_theory(const RunResult& result, double allowed, double allowed_pressure) {
  for (const char* quantity : {"velocity_x@middle", "velocity_z@middle"})
    EXPECT_LT(distance(result, quantity), allowed) << quantity;
  EXPECT_LT(distance(result, "pressure@middle"), allowed_pressure);
  for (const char* quantity : {"velocity_x@dry", "velocity_z@dry", "pressure@dry"})
    for (const double value : result.at(quantity).value) EXPECT_EQ(value, 0) << quantity;
}

void expect_walls_to_add_up(const RunResult& result, double tolerance) {
  for (const std::string component : {"force_x", "force_z"}) {
    const TimeSeries& whole = result.at(component);
    std::vector<double> sum(whole.value.size(), 0.0);
    for (const char* wall : {"left", "right", "bottom", "roof"}) {
      const TimeSeries& one = result.at(component + "@" + wall);
      EXPECT_EQ(one.time, whole.time);
      for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += one.value.at(i);
    }
    for (std::size_t i = 0; i < sum.size(); ++i)
      EXPECT_NEAR(sum[i], whole.value[i], tolerance) << component << " at " << whole.time[i];
  }
}

TEST(ProbesAndWalls, LinearTheoryHasNoLiquidAboveTheStillLevel) {
  for (const TimeSeries& series : linear_theory().series)
    EXPECT_FALSE(series.name.ends_with("@dry"));
  EXPECT_EQ(linear_theory().at("velocity_x@middle").unit, "m/s");
  EXPECT_EQ(linear_theory().at("velocity_x@middle").value.front(), 0);
}

TEST(ProbesAndWalls, OfPotentialFlowAreThoseOfLinearTheoryInASmallWave) {
  const RunResult result = run(standing_wave(), PotentialRun{.nodes_x = 24, .nodes_z = 12});
  expect_linear_theory(result, of_steepness, of_steepness);
  const TimeSeries &left = result.at("force_x@left"), &right = result.at("force_x@right"),
                   &whole = result.at("force_x");
  for (std::size_t i = 0; i < whole.value.size(); ++i)
    EXPECT_NEAR(left.value[i] + right.value[i], whole.value[i], 1e-9);
  EXPECT_EQ(result.at("force_z@bottom").value, result.at("force_z").value);
}

// The sound that the start leaves in a weakly compressible liquid adds to its pressure.
TEST(ProbesAndWalls, OfSphAreThoseOfLinearTheoryInASmallWaveAndTheWallsAddUp) {
  const RunResult result = run(standing_wave(), SphRun{"recommended", 0.025, 0.025});
  expect_linear_theory(result, of_coarse_particles, 2 * of_coarse_particles);
  expect_walls_to_add_up(result, 1e-6);
}

TEST(ProbesAndWalls, OfInterFoamAreThoseOfLinearTheoryInASmallWaveAndTheWallsAddUp) {
  if (openfoam::installed_version().empty()) GTEST_SKIP() << "interFoam is not installed";
  const RunResult result = run(standing_wave(), InterFoamRun{.cells_x = 40, .cells_z = 40});
  expect_linear_theory(result, of_coarse_cells, of_coarse_cells);
  expect_walls_to_add_up(result, 0.02);
}

TEST(ProbesAndWalls, AreQuantitiesOnWhichRunsAreCompared) {
  const std::vector<std::string> compared = compared_quantities(standing_wave());
  for (const char* quantity : {"velocity_x@middle", "velocity_z@middle", "pressure@middle",
                               "force_x@left", "force_x@right", "force_z@bottom", "force_z@roof"})
    EXPECT_NE(std::find(compared.begin(), compared.end(), quantity), compared.end()) << quantity;
  EXPECT_EQ(std::find(compared.begin(), compared.end(), "force_z@left"), compared.end());
  EXPECT_EQ(unit_of("force_z@left"), "N/m");
  EXPECT_EQ(find_quantity("force_x@front"), nullptr);
}

}  // namespace
}  // namespace slosh::probes_and_walls_test

// Each solver, coarse, against linear theory on the same case: a sign, a frame or a gauge
// translated wrongly shows. Every shipped run is also one that its solver accepts.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "openfoam_cases/run_case.hpp"
#include "verification/case_file/case_parser.hpp"
#include "verification/runs/run_case.hpp"
#include "verification/tests/sample_case.hpp"
#include "verification/tests/temporary_directory.hpp"

namespace slosh::solver_translation_test {
namespace {

// Linear theory is the truth to a few percent here; 30 % lets a coarse solver pass, a wrong sign or
// frame errs by 100 %.
constexpr double allowed = 0.3;

RunResult run(const CaseDefinition& definition, const decltype(RunDefinition::solver)& solver) {
  const TemporaryDirectory directory;
  const RunSettings settings{.work_directory = directory.path(),
                             .openfoam_templates = SLOSH_SOURCE_DIR "/openfoam_cases/sloshing_tank",
                             .key = {},
                             .command = {}};
  return execute(definition, sample_run(solver), settings, [](double, double) {});
}

// The first samples see the impulse of an abrupt start, of which each solver makes what its time
// step allows. [s]
constexpr double impulse_end = 0.1;

// How many of the first samples lack the forces: interFoam has none before its first step.
std::size_t forces_lacking(const decltype(RunDefinition::solver)& solver) {
  return std::holds_alternative<InterFoamRun>(solver) ? 1 : 0;
}

// `solver` lacks so many of the first samples.
double normalised_difference(const TimeSeries& solver, const TimeSeries& exact,
                             std::size_t lacking) {
  EXPECT_EQ(solver.value.size() + lacking, exact.value.size()) << solver.name;
  if (solver.value.size() + lacking != exact.value.size()) return INFINITY;
  double difference = 0, norm = 0;
  for (std::size_t i = 0; i < solver.value.size(); ++i) {
    EXPECT_NEAR(solver.time[i], exact.time[i + lacking], 5e-3);
    if (solver.time[i] < impulse_end) continue;
    difference += std::pow(solver.value[i] - exact.value[i + lacking], 2);
    norm += std::pow(exact.value[i + lacking], 2);
  }
  return std::sqrt(difference / norm);
}

enum class Force { compared, left_out };

void expect_linear_theory(Start start, const decltype(RunDefinition::solver)& solver,
                          Force force = Force::compared) {
  CaseDefinition definition = sample_case();
  definition.start = start;
  const RunResult exact =
      run(definition, LinearRun{.modes = 500, .valid_elevation_over_depth = 0.1});
  const RunResult result = run(definition, solver);
  const auto expect_near = [&](const char* name, std::size_t lacking) {
    const double difference = normalised_difference(result.at(name), exact.at(name), lacking);
    EXPECT_TRUE(difference <= allowed) << name << ": " << difference;
  };
  expect_near("elevation@left", 0);
  expect_near("elevation@right", 0);
  if (force == Force::compared) expect_near("force_x", forces_lacking(solver));
}

// A start in the earth's frame strikes the liquid with the walls, and it rings with sound (16 Hz
// here): for two seconds three times the wave's force.
TEST(SolverTranslation, SphFollowsLinearTheoryFromEitherStart) {
  const SphRun sph{"recommended", 0.025, 0.025};
  expect_linear_theory(Start::earth, sph, Force::left_out);
  expect_linear_theory(Start::tank, sph);
}

TEST(SolverTranslation, InterFoamFollowsLinearTheoryFromEitherStart) {
  if (openfoam::installed_version().empty()) GTEST_SKIP() << "interFoam is not installed";
  expect_linear_theory(Start::earth, InterFoamRun{40, 40, 1});
  expect_linear_theory(Start::tank, InterFoamRun{40, 40, 1});
}

// Roll about a point off the middle, ramped: pressures on either wall, force and moment as theory
// has them, each less its mean (the weight's).
void expect_linear_roll(const decltype(RunDefinition::solver)& solver) {
  CaseDefinition definition = sample_case();
  definition.motion.surge.reset();
  definition.motion.roll = RollDefinition{
      SineMotion{.amplitude = 0.02, .angular_frequency = 2.5, .ramp_periods = 0.5}, 0.4, 0.2};
  definition.start = Start::tank;
  definition.pressure_gauges = {
      {.name = "low", .wall = Wall::left, .position = 0.1},
      {.name = "wide", .wall = Wall::right, .position = 0.2, .width = 0.05}};
  definition.snapshot_times = {1.0};
  const RunResult exact =
      run(definition, LinearRun{.modes = 500, .valid_elevation_over_depth = 0.1});
  const RunResult result = run(definition, solver);
  const auto swinging = [](TimeSeries series) {
    std::erase_if(series.time, [](double t) { return t < impulse_end; });
    series.value.erase(series.value.begin(),
                       series.value.end() - static_cast<std::ptrdiff_t>(series.time.size()));
    double mean = 0;
    for (const double value : series.value)
      mean += value / static_cast<double>(series.value.size());
    for (double& value : series.value) value -= mean;
    return series;
  };
  for (const char* name : {"elevation@left", "elevation@right", "wall_pressure@low",
                           "wall_pressure@wide", "force_x", "moment"}) {
    const double difference =
        normalised_difference(swinging(result.at(name)), swinging(exact.at(name)), 0);
    EXPECT_TRUE(difference <= allowed) << name << ": " << difference;
  }
  ASSERT_EQ(result.snapshots.size(), 1);
  EXPECT_NEAR(result.snapshots[0].time, 1, 0.02);
  EXPECT_NEAR(static_cast<double>(result.snapshots[0].x.size()) * result.snapshots[0].width *
                  result.snapshots[0].height,
              0.35, 0.02);
}

TEST(SolverTranslation, SphFollowsLinearRollTheory) {
  expect_linear_roll(SphRun{"recommended", 0.025, 0.025});
}

TEST(SolverTranslation, InterFoamFollowsLinearRollTheory) {
  if (openfoam::installed_version().empty()) GTEST_SKIP() << "interFoam is not installed";
  expect_linear_roll(InterFoamRun{40, 80, 1});
}

// Let go from rest: the elevations, the force on the walls and the pressure in a corner.
void expect_linear_wave(const decltype(RunDefinition::solver)& solver, double gas_density) {
  CaseDefinition definition = sample_case();
  definition.motion = {};
  definition.initial_wave = InitialWaveDefinition{1, 0.01};
  definition.start = Start::tank;
  definition.gas.density = gas_density;
  const RunResult exact =
      run(definition, LinearRun{.modes = 0, .two_layer = true, .valid_elevation_over_depth = 0.1});
  const RunResult result = run(definition, solver);
  EXPECT_NEAR(result.at("elevation@left").value.front(), exact.at("elevation@left").value.front(),
              1e-4);
  for (const char* name : {"elevation@left", "elevation@right", "force_x"}) {
    const std::size_t lacking = std::string(name) == "force_x" ? forces_lacking(solver) : 0;
    const double difference = normalised_difference(result.at(name), exact.at(name), lacking);
    EXPECT_TRUE(difference <= allowed) << name << ": " << difference;
  }
}

TEST(SolverTranslation, SphSwingsAnInitialWave) {
  expect_linear_wave(SphRun{"recommended", 0.025, 0.025}, 0);
}

TEST(SolverTranslation, InterFoamSwingsAnInitialWave) {
  if (openfoam::installed_version().empty()) GTEST_SKIP() << "interFoam is not installed";
  expect_linear_wave(InterFoamRun{40, 80, 1}, 1.2);
}

TEST(SolverTranslation, LinearTheoryAddsSurgeAndRollOnStillWaterCountedOnce) {
  CaseDefinition both = sample_case();
  both.motion.roll =
      RollDefinition{SineMotion{.amplitude = 0.02, .angular_frequency = 2.5}, 0.4, 0.2};
  both.pressure_gauges = {{.name = "low", .wall = Wall::left, .position = 0.1}};
  CaseDefinition surge = both, roll = both;
  surge.motion.roll.reset();
  roll.motion.surge.reset();
  const LinearRun linear{.modes = 50, .valid_elevation_over_depth = 0.1};
  const RunResult sum = run(both, linear), one = run(surge, linear), two = run(roll, linear);
  const double still = 1000 * 9.81 * 0.25;
  for (const std::size_t i : {1u, 40u, 77u}) {
    EXPECT_NEAR(sum.at("elevation@left").value[i],
                one.at("elevation@left").value[i] + two.at("elevation@left").value[i], 1e-12);
    EXPECT_NEAR(sum.at("wall_pressure@low").value[i],
                one.at("wall_pressure@low").value[i] + two.at("wall_pressure@low").value[i] - still,
                1e-8);
    EXPECT_NEAR(sum.at("force_x").value[i], one.at("force_x").value[i] + two.at("force_x").value[i],
                1e-8);
  }
}

TEST(SolverTranslation, InterFoamLeavesItsSeriesAndDiagnostics) {
  if (openfoam::installed_version().empty()) GTEST_SKIP() << "interFoam is not installed";
  CaseDefinition definition = sample_case();
  definition.duration = 0.1;
  const RunResult result = run(definition, InterFoamRun{20, 20, 1});
  EXPECT_EQ(result.solver, "interfoam");
  EXPECT_EQ(result.at("force_x").unit, "N/m");
  EXPECT_NEAR(result.at("liquid_volume").value.front(), 0.35, 1e-6);
  EXPECT_LT(std::abs(result.diagnostics.at("relative_mass_loss")), 1e-3);
  EXPECT_GT(result.cost.steps, 10);
  EXPECT_EQ(result.cost.elements, 400);
  EXPECT_FALSE(result.provenance.at("openfoam_version").empty());
}

// Returns the rms of the elevation in a tank of this breadth over that without friction.
double slowed_by(double breadth, const decltype(RunDefinition::solver)& solver) {
  CaseDefinition definition = sample_case();
  definition.liquid.kinematic_viscosity = 1e-4;
  const auto rms = [&] {
    const TimeSeries elevation = run(definition, solver).at("elevation@right");
    double sum = 0;
    for (const double value : elevation.value) sum += value * value;
    return std::sqrt(sum / static_cast<double>(elevation.value.size()));
  };
  const double free = rms();
  definition.tank.breadth = breadth;
  return rms() / free;
}

// Measured: to 0.517 and 0.520 of the elevation without friction.
TEST(SolverTranslation, ABreadthSlowsTheLiquidOfSphAndInterFoamAlike) {
  if (openfoam::installed_version().empty()) GTEST_SKIP() << "interFoam is not installed";
  const double sph = slowed_by(0.02, SphRun{"recommended", 0.02, 0.02}),
               interfoam = slowed_by(0.02, InterFoamRun{40, 40, 1});
  EXPECT_LE(sph, 0.9);
  EXPECT_NEAR(sph, interfoam, 0.05);
}

TEST(SolverTranslation, InterFoamWithoutItsTemplatesIsASolverError) {
  const TemporaryDirectory directory;
  EXPECT_THROW(execute(sample_case(), sample_run(InterFoamRun{20, 20, 1}),
                       {.work_directory = directory.path(),
                        .openfoam_templates = directory.path() / "absent",
                        .key = {},
                        .command = {}},
                       [](double, double) {}),
               SolverError);
}

TEST(ShippedCases, HoldNoRunThatItsSolverRefuses) {
  for (const auto& entry :
       std::filesystem::directory_iterator(SLOSH_SOURCE_DIR "/verification/cases")) {
    if (entry.path().extension() != ".toml") continue;
    const CaseDefinition definition = read_case(entry.path());
    for (const RunDefinition& run : definition.runs)
      EXPECT_NO_THROW(require_runnable(definition, run)) << definition.name << "/" << run.name;
  }
}

}  // namespace
}  // namespace slosh::solver_translation_test

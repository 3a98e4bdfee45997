// A motion of two sines, one of which begins at its crest, as each solver receives it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <numbers>
#include <string>

#include "openfoam_cases/run_case.hpp"
#include "sph/scene.hpp"
#include "verification/case/motion.hpp"
#include "verification/case/quantities.hpp"
#include "verification/runs/run_case.hpp"
#include "verification/series/windowed_series.hpp"
#include "verification/solvers/sph_scene.hpp"
#include "verification/tests/sample_case.hpp"
#include "verification/tests/temporary_directory.hpp"

namespace slosh::sines_translation_test {
namespace {

constexpr SineMotion first{.amplitude = 0.01, .angular_frequency = 2, .phase = 0.6},
    second{.amplitude = 0.004, .angular_frequency = 7, .phase = std::numbers::pi / 2};
constexpr LinearRun linear{.modes = 500, .valid_elevation_over_depth = 0.1};

CaseDefinition case_of(const MotionHistory& surge, Start start) {
  CaseDefinition definition = sample_case();
  definition.motion.surge = surge;
  definition.start = start;
  definition.pressure_gauges = {{.name = "low", .wall = Wall::left, .position = 0.1}};
  return definition;
}

RunResult run(const CaseDefinition& definition, const decltype(RunDefinition::solver)& solver,
              const std::filesystem::path& directory) {
  return execute(definition, sample_run(solver),
                 {.work_directory = directory,
                  .openfoam_templates = SLOSH_SOURCE_DIR "/openfoam_cases/sloshing_tank",
                  .key = {},
                  .command = {}},
                 [](double, double) {});
}

RunResult run(const CaseDefinition& definition, const decltype(RunDefinition::solver)& solver) {
  const TemporaryDirectory directory;
  return run(definition, solver, directory.path());
}

// The rms of the difference over that of the exact series, from the first samples on that the
// impulse of an abrupt start no longer shapes.
double normalised_difference(const TimeSeries& series, const TimeSeries& exact) {
  constexpr double impulse_end = 0.1;  // [s]
  double difference = 0, norm = 0;
  for (std::size_t i = 0; i < exact.value.size(); ++i) {
    if (exact.time[i] < impulse_end) continue;
    difference += std::pow(series.value.at(i) - exact.value[i], 2);
    norm += std::pow(exact.value[i], 2);
  }
  return std::sqrt(difference / norm);
}

TEST(SinesTranslation, LinearTheoryAddsTheClosedFormsOfTheSines) {
  for (const Start start : {Start::earth, Start::tank}) {
    const RunResult sum = run(case_of(SumOfSines{{first, second}}, start), linear),
                    one = run(case_of(first, start), linear),
                    two = run(case_of(second, start), linear);
    EXPECT_EQ(sum.active_terms.back(), "closed form of 2 sine surges");
    const double still = 1000 * 9.81 * 0.25;  // counted once
    for (const std::size_t i : {0u, 40u, 77u}) {
      EXPECT_NEAR(sum.at("elevation@left").value[i],
                  one.at("elevation@left").value[i] + two.at("elevation@left").value[i], 1e-14);
      EXPECT_NEAR(
          sum.at("wall_pressure@low").value[i],
          one.at("wall_pressure@low").value[i] + two.at("wall_pressure@low").value[i] - still,
          1e-9);
      EXPECT_NEAR(sum.at("force_x").value[i],
                  one.at("force_x").value[i] + two.at("force_x").value[i], 1e-9);
    }
  }
}

// A ramp of no length in all but name leaves the motion as it is and makes the run take Duhamel's
// integral. Its error is (omega step)^2 / 12 of the faster sine, 1e-4 with the step of 5 ms.
TEST(SinesTranslation, LinearTheoryByDuhamelsIntegralEqualsTheClosedForms) {
  for (const Start start : {Start::earth, Start::tank}) {
    const CaseDefinition closed = case_of(SumOfSines{{first, second}}, start);
    CaseDefinition integrated = closed;
    TableMotion table{"two_sines.csv", {}, {}};
    const SurgeMotion motion = surge_motion(closed);
    for (int i = 0; i <= 2100; ++i) {
      table.time.push_back(1e-3 * i);
      table.value.push_back(motion.displacement(1e-3 * i));
    }
    integrated.motion.surge = table;
    const RunResult exact = run(closed, linear), by_integral = run(integrated, linear);
    EXPECT_EQ(by_integral.active_terms.back(), "Duhamel's integral of the motion");
    for (const char* name : {"elevation@left", "elevation@right", "force_x"}) {
      const double difference = normalised_difference(by_integral.at(name), exact.at(name));
      EXPECT_LE(difference, 4e-4) << name;
    }
  }
}

TEST(SinesTranslation, SphReceivesTheSumAndItsDerivatives) {
  const CaseDefinition definition = case_of(SumOfSines{{first, second}}, Start::tank);
  const sph::Scene scene = sph_scene(definition, SphRun{"recommended", 0.025, 0.025});
  for (const double t : {0.0, 0.31, 1.7}) {
    const double a = 2 * t + 0.6, b = 7 * t + std::numbers::pi / 2;
    EXPECT_NEAR(scene.displacement(t), 0.01 * std::sin(a) + 0.004 * std::sin(b), 1e-15);
    EXPECT_NEAR(scene.velocity(t), 0.02 * std::cos(a) + 0.028 * std::cos(b), 1e-15);
    EXPECT_NEAR(scene.acceleration(t), -0.04 * std::sin(a) - 0.196 * std::sin(b), 1e-15);
  }
}

// Returns the normalised differences between potential flow and linear theory at a hundredth of the
// amplitude, where nonlinear flow is linear to a share of it.
std::map<std::string, double> difference_from_linear_theory(Start start, int nodes_x) {
  SineMotion slow = first, fast = second;
  slow.amplitude /= 100;
  fast.amplitude /= 100;
  const CaseDefinition definition = case_of(SumOfSines{{slow, fast}}, start);
  const RunResult exact = run(definition, linear),
                  result = run(definition, PotentialRun{.nodes_x = nodes_x, .nodes_z = 16});
  EXPECT_EQ(result.at("elevation@left").value.size(), exact.at("elevation@left").value.size());
  std::map<std::string, double> differences;
  for (const char* name : {"elevation@left", "elevation@right", "force_x"})
    differences[name] = normalised_difference(result.at(name), exact.at(name));
  return differences;
}

TEST(SinesTranslation, PotentialFlowFollowsLinearTheoryAtASmallAmplitude) {
  for (const auto& [name, difference] : difference_from_linear_theory(Start::tank, 48))
    EXPECT_LE(difference, 5e-3) << name;
}

// A sudden start excites waves at the walls that are shorter than any grid resolves. The force does
// not feel them; the elevation at a wall nears linear theory with the grid.
TEST(SinesTranslation, PotentialFlowNearsLinearTheoryAfterASuddenStart) {
  auto coarse = difference_from_linear_theory(Start::earth, 24),
       fine = difference_from_linear_theory(Start::earth, 72);
  for (const char* name : {"elevation@left", "elevation@right"})
    EXPECT_LE(fine[name], coarse[name] / 1.5) << name;
  EXPECT_LE(fine["force_x"], 5e-3);
}

TEST(SinesTranslation, SphFollowsLinearTheory) {
  const CaseDefinition definition = case_of(SumOfSines{{first, second}}, Start::tank);
  const RunResult exact = run(definition, linear),
                  result = run(definition, SphRun{"recommended", 0.025, 0.025});
  for (const char* name : {"elevation@left", "elevation@right"})
    EXPECT_LE(normalised_difference(result.at(name), exact.at(name)), 0.3) << name;
}

// Returns the times and accelerations along x of a case's table "(t ((x y z) (...) (...)))".
std::vector<std::array<double, 2>> acceleration_table(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  text.erase(0, text.find_first_of('('));
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '(' || c == ')'; }, ' ');
  std::istringstream numbers(text);
  std::vector<double> all;
  for (double number = 0; numbers >> number;) all.push_back(number);
  std::vector<std::array<double, 2>> rows;
  for (std::size_t i = 0; i + 10 <= all.size(); i += 10) rows.push_back({all[i], all[i + 1]});
  return rows;
}

TEST(SinesTranslation, InterFoamReceivesTheSumsAccelerationAndFollowsLinearTheory) {
  if (openfoam::installed_version().empty()) GTEST_SKIP() << "interFoam is not installed";
  for (const Start start : {Start::earth, Start::tank}) {
    const TemporaryDirectory directory;
    const CaseDefinition definition = case_of(SumOfSines{{first, second}}, start);
    const RunResult exact = run(definition, linear),
                    result = run(definition, InterFoamRun{40, 80, 1}, directory.path());
    for (const char* name : {"elevation@left", "elevation@right"})
      EXPECT_LE(normalised_difference(result.at(name), exact.at(name)), 0.3) << name;
    const auto rows =
        acceleration_table(directory.path() / "a_run.openfoam" / "constant" / "acceleration");
    ASSERT_GE(rows.size(), 2000u);
    for (const auto& [t, along_x] : rows)
      EXPECT_NEAR(along_x,
                  -0.04 * std::sin(2 * t + 0.6) - 0.196 * std::sin(7 * t + std::numbers::pi / 2),
                  1e-12);
  }
}

// Velocity and pressure at a place, and force by wall, of one small standing wave by all solvers
// that record them. Linear theory leaves out what is of the order of the wave's steepness, 1.3 %.

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
}  // namespace slosh::sines_translation_test

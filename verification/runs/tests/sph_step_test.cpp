#include "verification/runs/sph_step.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "verification/runs/run_case.hpp"
#include "verification/tests/sample_case.hpp"

namespace slosh::sph_step_test {
namespace {

SphRun coarse(const std::string& scheme, const std::string& variant = "") {
  return {.scheme = scheme,
          .particle_spacing = 0.05,
          .surface_particle_spacing = 0.05,
          .variant = variant};
}

CaseDefinition short_case() {
  CaseDefinition definition = sample_case();
  definition.duration = definition.window_end = 0.2;
  return definition;
}

// What the solver then takes: the forecast knows no violent flow, of which this case has none.
void expect_as_taken(const CaseDefinition& definition, const SphRun& sph) {
  const RunDefinition run = sample_run(sph);
  const auto step = sph_step(definition, run);
  ASSERT_TRUE(step);
  const RunResult result = execute(definition, run, {}, [](double, double) {});
  EXPECT_NEAR(definition.duration / step->between_samples, result.cost.steps, 1e-6)
      << sph.scheme << " " << sph.variant;
  EXPECT_NEAR(step->between_samples, result.diagnostics.at("smallest_time_step_s"), 1e-12)
      << sph.scheme << " " << sph.variant;
}

TEST(SphStep, IsWhatTheSolverTakesOfEveryScheme) {
  for (const char* scheme :
       {"recommended", "li2010", "delta_sph", "zhao2021_moving", "zhao2021_fixed"})
    expect_as_taken(short_case(), coarse(scheme));
}

TEST(SphStep, IsWhatTheSolverTakesOfVariantsAndNumbers) {
  for (const char* variant : {"verlet", "symplectic", "wendland_c2", "laminar_viscosity"})
    expect_as_taken(short_case(), coarse("recommended", variant));
  SphRun changed = coarse("recommended");
  changed.numbers.sound_speed_ratio = 20;
  changed.numbers.smoothing_length_ratio = 1.75;
  expect_as_taken(short_case(), changed);
  CaseDefinition viscous = short_case();
  viscous.liquid.kinematic_viscosity = 0.2;
  expect_as_taken(viscous, coarse("recommended", "laminar_viscosity"));
}

TEST(SphStep, IsWhatTheSolverTakesInATankThatRolls) {
  CaseDefinition rolling = short_case();
  rolling.motion.surge.reset();
  rolling.motion.roll = {.angle = SineMotion{0.05, 2}, .axis_x = 0.5, .axis_z = 0};
  for (const char* scheme : {"recommended", "li2010", "delta_sph", "zhao2021_fixed"})
    expect_as_taken(rolling, coarse(scheme));
}

TEST(SphStep, IsWhatTheSolverTakesOfTwoSpacings) {
  SphRun sph = coarse("li2010");
  sph.surface_particle_spacing = 0.025;
  expect_as_taken(short_case(), sph);
}

TEST(SphStep, IsShorterWhereSamplesAreDenser) {
  CaseDefinition definition = short_case();
  const RunDefinition run = sample_run(coarse("recommended"));
  const double stable = sph_step(definition, run)->stable;
  definition.sample_interval = 0.01;
  EXPECT_EQ(sph_step(definition, run)->stable, stable);
  definition.sample_interval = 0.6 * stable;
  EXPECT_NEAR(sph_step(definition, run)->lost_to_samples(), 0.4, 1e-12);
  definition.sample_interval = 1.01 * stable;
  EXPECT_NEAR(sph_step(definition, run)->lost_to_samples(), 1 - 1.01 / 2, 1e-12);
  definition.sample_interval = 3 * stable;
  EXPECT_NEAR(sph_step(definition, run)->lost_to_samples(), 0, 1e-9);
}

TEST(SphStep, IsUnknownOfAnotherSolverAndOfARunThatIsRefused) {
  EXPECT_FALSE(sph_step(short_case(), sample_run(LinearRun{})));
  EXPECT_FALSE(sph_step(short_case(), sample_run(coarse("recomended"))));
  SphRun odd = coarse("recommended");
  odd.particle_spacing = odd.surface_particle_spacing = 0.3;
  EXPECT_FALSE(sph_step(short_case(), sample_run(odd)));
}

}  // namespace
}  // namespace slosh::sph_step_test

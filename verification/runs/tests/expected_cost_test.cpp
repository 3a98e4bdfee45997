#include "verification/runs/expected_cost.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "verification/runs/run_case.hpp"
#include "verification/runs/sph_step.hpp"
#include "verification/tests/sample_case.hpp"
#include "verification/tests/temporary_directory.hpp"

namespace slosh::expected_cost_test {
namespace {

RunDefinition particles(double spacing) {
  return sample_run(SphRun{
      .scheme = "recommended", .particle_spacing = spacing, .surface_particle_spacing = spacing});
}

RunDefinition linear(int modes) {
  LinearRun solver;
  solver.modes = modes;
  return sample_run(solver);
}

RunDefinition external_run() {
  ExternalRun external{};
  external.command = {"a"};
  return sample_run(external);
}

class ExpectedCostTest : public ::testing::Test {
 protected:
  ExpectedCost cost_of(const RunDefinition& run) const {
    return expected_cost(sample_case(), run, "question-answer", store);
  }
  void record(const RunDefinition& run, double seconds) const {
    RunResult result;
    result.cost = {.wall_time = seconds, .user_time = seconds, .peak_memory = 1e7};
    record_cost(result, sample_case(), run, store);
  }

  TemporaryDirectory directory;
  const ResultStore store{directory.path()};
};

TEST_F(ExpectedCostTest, IsUnknownWhereNothingWasMeasured) {
  EXPECT_FALSE(cost_of(particles(0.01)).known());
  EXPECT_EQ(cost_text(cost_of(particles(0.01))), "core-seconds not known");
  EXPECT_EQ(time_limit(cost_of(particles(0.01))), 72000);
}

// Half the spacing has four times the particles and half the step.
TEST_F(ExpectedCostTest, IsThatOfTheLastRunOfTheKindByParticlesAndSteps) {
  record(particles(0.02), 999);
  record(particles(0.02), 3);
  const ExpectedCost fine = cost_of(particles(0.01));
  EXPECT_NEAR(fine.processor_time, 24, 1) << "whole steps between the samples";
  EXPECT_DOUBLE_EQ(fine.memory, 4e7);
  EXPECT_FALSE(fine.measured);
  EXPECT_EQ(cost_text({.processor_time = 24}), "about 24 core-seconds, scaled from another run");
  EXPECT_DOUBLE_EQ(cost_of(particles(0.04)).memory, 1e7) << "a base that does not shrink";
  RunDefinition other = particles(0.01);
  std::get<SphRun>(other.solver).scheme = "li2010";
  EXPECT_FALSE(cost_of(other).known()) << "another kind";
}

TEST_F(ExpectedCostTest, ScalesEachSolverByWhatItComputes) {
  record(sample_run(InterFoamRun{.cells_x = 10, .cells_z = 10}), 1);
  EXPECT_NEAR(cost_of(sample_run(InterFoamRun{.cells_x = 20, .cells_z = 20})).processor_time, 8,
              1e-3);
  record(sample_run(PotentialRun{.nodes_x = 10, .nodes_z = 10}), 1);
  EXPECT_NEAR(cost_of(sample_run(PotentialRun{.nodes_x = 20, .nodes_z = 20})).processor_time, 4,
              1e-3);
  record(linear(10), 1);
  EXPECT_NEAR(cost_of(linear(30)).processor_time, 3, 1e-3);
}

TEST_F(ExpectedCostTest, ReadsPastLinesThatAreNoRecord) {
  record(particles(0.01), 7);
  std::ofstream(directory.path() / "costs.txt", std::ios::app)
      << "sph 10 20\n0 0 9 9 recommended\nnan nan nan nan recommended\n1 1 1\n\n";
  EXPECT_DOUBLE_EQ(cost_of(particles(0.01)).processor_time, 7);
}

TEST_F(ExpectedCostTest, LearnsNothingFromARunThatEndedEarlyOrThatIsNotOurs) {
  record(external_run(), 50);
  RunResult early;
  early.cost.user_time = 50;
  early.provenance["left_range_because"] = "the surface is too steep";
  record_cost(early, sample_case(), sample_run(PotentialRun{}), store);
  EXPECT_FALSE(std::filesystem::exists(directory.path() / "costs.txt"));
}

TEST_F(ExpectedCostTest, KeepsTheLimitsOfAnExternalProgram) {
  RunDefinition run = external_run();
  EXPECT_EQ(time_limit(cost_of(run)), 72000) << "it may take long";
  auto& external = std::get<ExternalRun>(run.solver);
  external.cores = 2;
  external.time_limit = 7200;
  EXPECT_EQ(cost_of(run).cores, 2);
  EXPECT_EQ(cost_of(run).wall_time, 0) << "a limit is no expectation";
  EXPECT_EQ(time_limit(cost_of(run)), 7320) << "its own limit ends it first";
}

TEST_F(ExpectedCostTest, IsWhatAnEarlierRunWithTheSameKeyTook) {
  RunResult result;
  result.cost = {.wall_time = 100, .user_time = 80, .system_time = 10, .peak_memory = 5e6};
  write_result(result, store.file("question-answer", ".h5"));
  const ExpectedCost cost = cost_of(external_run());
  EXPECT_TRUE(cost.measured);
  EXPECT_EQ(cost_text(cost), "90 core-seconds measured");
  EXPECT_EQ(cost.wall_time, 100);
  EXPECT_EQ(time_limit(cost), 2000);
}

SphRun coarse(const std::string& scheme, const std::string& variant = "") {
  return {.scheme = scheme,
          .particle_spacing = 0.05,
          .surface_particle_spacing = 0.05,
          .variant = variant};
}

CaseDefinition short_case() {
  CaseDefinition definition = sample_case();
  definition.duration = definition.window_end = 0.04;
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
}  // namespace slosh::expected_cost_test

#include "verification/runs/expected_cost.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

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

}  // namespace
}  // namespace slosh::expected_cost_test

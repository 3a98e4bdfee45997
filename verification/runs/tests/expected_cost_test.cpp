#include "verification/runs/expected_cost.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "verification/runs/cost_records.hpp"
#include "verification/tests/sample_case.hpp"
#include "verification/tests/temporary_directory.hpp"

namespace slosh::expected_cost_test {
namespace {

const RunDefinition particles = sample_run(
    SphRun{.scheme = "recommended", .particle_spacing = 0.01, .surface_particle_spacing = 0.01});
const RunDefinition mesh = sample_run(InterFoamRun{.cells_x = 50, .cells_z = 50});

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

  TemporaryDirectory directory;
  const ResultStore store{directory.path()};
};

TEST_F(ExpectedCostTest, IsAnEstimateWhereNothingWasMeasured) {
  const ExpectedCost cost = cost_of(particles);
  EXPECT_FALSE(cost.measured);
  EXPECT_EQ(cost.uncertainty, 2);
  EXPECT_EQ(cost_text({.processor_time = 12, .wall_time = 12, .memory = 0, .uncertainty = 1.5}),
            "about 12 core-seconds, an estimate: 8 to 18");
  EXPECT_EQ(cost_text({.processor_time = 1.4, .wall_time = 1, .memory = 0, .measured = true}),
            "1.4 core-seconds measured");
}

TEST_F(ExpectedCostTest, LearnsFromOtherRunsOfTheSolverOnThisMachine) {
  const double before = cost_of(particles).processor_time, of_mesh = cost_of(mesh).processor_time;
  for (const double taken : {30.0, 31.0, 900.0}) record_cost({"sph", 10, taken}, store);
  EXPECT_DOUBLE_EQ(cost_of(particles).processor_time, 3.1 * before) << "the median";
  EXPECT_EQ(cost_of(particles).uncertainty, 1.5);
  EXPECT_EQ(cost_of(mesh).processor_time, of_mesh) << "of another solver";
  EXPECT_EQ(cost_of(mesh).uncertainty, 2);
}

TEST_F(ExpectedCostTest, ForgetsWhatIsLongAgoAndWhatIsNoRecord) {
  for (int i = 0; i < 40; ++i) record_cost({"sph", 10, 100}, store);
  std::ofstream(directory.path() / "costs.txt", std::ios::app) << "sph x\nsph 1\nsph -1 3\n\n";
  for (int i = 0; i < 30; ++i) record_cost({"sph", 10, 20}, store);
  EXPECT_DOUBLE_EQ(machine_factor("sph", store).value(), 2);
  for (int i = 0; i < 9000; ++i) record_cost({"sph", 10, 50}, store);
  EXPECT_DOUBLE_EQ(machine_factor("sph", store).value(), 5);
}

TEST_F(ExpectedCostTest, LearnsNothingFromARunOfAnInstant) {
  record_cost({"sph", 0.01, 0.5}, store);
  EXPECT_FALSE(machine_factor("sph", store));
  EXPECT_FALSE(machine_factor("sph", ResultStore(directory.path() / "none")));
}

TEST_F(ExpectedCostTest, LearnsNothingFromARunThatEndedEarlyOrThatIsNotOurs) {
  RunResult result;
  result.cost.user_time = 50;
  learn_cost(result, sample_case(), external_run(), store);
  EXPECT_FALSE(machine_factor("external", store));
  result.provenance["left_range_because"] = "the surface is too steep";
  learn_cost(result, sample_case(), sample_run(PotentialRun{}), store);
  EXPECT_FALSE(machine_factor("potential", store));
  result.provenance.clear();
  learn_cost(result, sample_case(), sample_run(PotentialRun{}), store);
  EXPECT_TRUE(machine_factor("potential", store));
}

TEST_F(ExpectedCostTest, IsUnknownOfAnExternalProgram) {
  RunDefinition run = external_run();
  EXPECT_EQ(cost_text(cost_of(run)), "core-seconds not known");
  EXPECT_EQ(cost_of(run).processor_time, 0);
  EXPECT_EQ(cost_of(run).wall_time, 0);
  EXPECT_EQ(time_limit(cost_of(run)), 72000) << "it may take long";
  auto& external = std::get<ExternalRun>(run.solver);
  external.cores = 2;
  external.time_limit = 7200;
  EXPECT_EQ(cost_of(run).cores, 2);
  EXPECT_EQ(cost_of(run).wall_time, 0) << "a limit is no expectation";
  EXPECT_EQ(time_limit(cost_of(run)), 7320) << "its own limit ends it first";
}

TEST_F(ExpectedCostTest, IsWhatAnEarlierRunOfAnExternalProgramTook) {
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

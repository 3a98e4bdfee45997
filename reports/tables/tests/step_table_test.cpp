// What a particle's step costs: of which time, of which particles, and what stays blank.
#include <gtest/gtest.h>

#include "reports/tables/case_tables.hpp"
#include "verification/tests/impact_runs.hpp"

namespace slosh::step_table_test {
namespace {

RunResult& result_of(CaseAssessment& assessment, const std::string& run) {
  return assessment.runs.results.at(run);
}

CaseAssessment own_run() {
  CaseAssessment assessment = no_runs_of(impact_case());
  add_run(assessment, "own", SphRun{"recommended", 0.01, 0.01}, {});
  RunResult& own = result_of(assessment, "own");
  own.cost = {.user_time = 3, .system_time = 1, .steps = 1000, .elements = 4000};
  own.diagnostics = {{"speed_of_sound_m_s", 20}, {"evaluations_per_step", 1}};
  own.provenance = {{"compiler_flags", "-O3"}};
  return assessment;
}

CaseAssessment with_peer() {
  CaseAssessment assessment = own_run();
  add_run(assessment, "peer",
          ExternalRun{.command = {"peer"}, .method = "peer", .particle_spacing = 0.01}, {});
  RunResult& peer = result_of(assessment, "peer");
  peer.cost = {.user_time = 100, .steps = 2000, .elements = 4000};
  peer.diagnostics = {
      {"wall_particles", 1000}, {"loop_processor_time_s", 16}, {"speed_of_sound_m_s", 18.5}};
  peer.provenance = {};
  return assessment;
}

TEST(StepTable, IsLeftOutWhereNoOtherCodeTellsItsCounts) {
  EXPECT_FALSE(step_table(own_run()));
  CaseAssessment silent = with_peer();
  result_of(silent, "peer").cost.steps = 0;
  EXPECT_FALSE(step_table(silent));
}

TEST(StepTable, CountsTheTimeLoopWhereItIsToldAndTheWholeRunElse) {
  const auto table = step_table(with_peer());
  ASSERT_TRUE(table);
  ASSERT_EQ(table->rows.size(), 2u);
  EXPECT_EQ(table->rows[0], (std::vector<std::string>{"own", "4000", "", "1000", "1", "whole run",
                                                      "1e+03", "", "20", "-O3"}));
  // 16 s over 8 million steps of the liquid's particles, and 10 million of all.
  EXPECT_EQ(table->rows[1],
            (std::vector<std::string>{"peer", "4000", "1000", "2000", "", "time loop", "2e+03",
                                      "1.6e+03", "18.5", ""}));
}

// Slosh's flags did not build it.
TEST(StepTable, LeavesTheFlagsOfInterFoamBlank) {
  CaseAssessment assessment = with_peer();
  add_run(assessment, "mesh", InterFoamRun{.cells_x = 20, .cells_z = 20}, {});
  result_of(assessment, "mesh").provenance = {{"compiler_flags", "-O3"},
                                              {"openfoam_version", "1912"}};
  const auto table = step_table(assessment);
  ASSERT_TRUE(table);
  EXPECT_EQ(table->rows.at(2).back(), "");
}

}  // namespace
}  // namespace slosh::step_table_test

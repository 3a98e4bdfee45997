#include "verification/evidence/run_cost.hpp"

#include <gtest/gtest.h>

#include "verification/tests/sample_case.hpp"

namespace slosh::run_cost_test {
namespace {

TEST(LeftOutAsCompiling, IsToldOfTheRunWithTheLargestShareAndDoubtfulAboveOneHalf) {
  CaseDefinition definition = sample_case();
  CaseRuns runs;
  const auto add = [&](const char* name, double spacing, double took) {
    ExternalRun external;
    external.command = {"./solve"};
    external.method = "mine";
    external.particle_spacing = spacing;
    RunDefinition run{};
    run.name = name;
    run.solver = external;
    definition.runs.push_back(run);
    runs.results[name].cost.user_time = took;
  };
  add("coarse", 0.04, 1.5);
  add("fine", 0.02, 6);
  GateRow row{};
  row.candidate = "fine";
  EXPECT_EQ(left_out_as_compiling(definition, runs, row), "") << "no program says so";
  runs.results["coarse"].diagnostics["compile_processor_time_s"] = 0;
  EXPECT_EQ(left_out_as_compiling(definition, runs, row), "");
  runs.results["coarse"].diagnostics["compile_processor_time_s"] = 0.5;
  runs.results["fine"].diagnostics["compile_processor_time_s"] = 0.6;
  EXPECT_EQ(left_out_as_compiling(definition, runs, row),
            "; coarse says itself that 0.5 s were compiling, 25 % of what it took; they do not "
            "count");
  runs.results["fine"].diagnostics["compile_processor_time_s"] = 9;
  EXPECT_EQ(left_out_as_compiling(definition, runs, row),
            "; doubtful: fine says itself that 9 s were compiling, 60 % of what it took; they do "
            "not count");
}

}  // namespace
}  // namespace slosh::run_cost_test

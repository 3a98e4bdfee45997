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
  EXPECT_EQ(left_out_as_compiling(definition, runs, row).text, "") << "no program says so";
  runs.results["coarse"].diagnostics["compile_processor_time_s"] = 0;
  EXPECT_EQ(left_out_as_compiling(definition, runs, row).text, "");
  runs.results["coarse"].diagnostics["compile_processor_time_s"] = 0.5;
  runs.results["fine"].diagnostics["compile_processor_time_s"] = 0.6;
  EXPECT_EQ(left_out_as_compiling(definition, runs, row).text,
            "; coarse says itself that 0.5 s were compiling, 25 % of what it took; they do not "
            "count");
  runs.results["fine"].diagnostics["compile_processor_time_s"] = 9;
  EXPECT_EQ(left_out_as_compiling(definition, runs, row).text,
            "; doubtful: fine says itself that 9 s were compiling, 60 % of what it took; they do "
            "not count");
}

// A program that keeps its result beside it is fast when it is timed.
TEST(LeftOutAsCompiling, DoubtsACostThatTheRunItselfExceeds) {
  CaseDefinition definition = sample_case();
  RunDefinition run{};
  run.name = "fine";
  run.solver = ExternalRun{.command = {"./solve"}, .method = "mine", .particle_spacing = 0.02};
  definition.runs.push_back(run);
  GateRow row{};
  row.candidate = "fine";
  for (const auto& [first, is_doubted] :
       {std::pair{0.8, true}, {0.12, false}, {0.06, false}, {0.01, false}}) {
    CaseRuns runs;
    runs.results["fine"].cost.user_time = first;
    for (const double again : {0.058, 0.06}) {
      RunCost cost{};
      cost.user_time = again;
      runs.timings["fine"].push_back(cost);
    }
    const RowDoubts told = left_out_as_compiling(definition, runs, row);
    EXPECT_EQ(told.is_doubtful, is_doubted) << first;
    EXPECT_EQ(told.text.find("doubtful") != std::string::npos, is_doubted) << first;
  }
}

}  // namespace
}  // namespace slosh::run_cost_test

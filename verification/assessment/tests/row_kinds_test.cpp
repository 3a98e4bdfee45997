// What the headline says of the rows' kinds and of what they rest on.
#include "verification/assessment/row_kinds.hpp"

#include <gtest/gtest.h>

#include "verification/tests/surge_results.hpp"

namespace slosh::row_kinds_test {
namespace {

TEST(RowKinds, AreCountedApartWithWhatTheirRowsRestOn) {
  CaseDefinition definition = surge_case();
  GateRow of_mesh = definition.gate.at(0);  // without a refinement: inconclusive
  of_mesh.reference = "coarse_mesh";
  GateRow earlier = definition.gate.at(1);
  earlier.kind = RowKind::regression;
  GateRow worse = definition.gate.at(0);
  worse.kind = RowKind::regression;
  worse.limit = 1e-5;
  definition.gate = {definition.gate.at(0), of_mesh, earlier, worse};
  CaseRuns runs = surge_runs();
  for (double& value : runs.results.at("particles").series.at(0).value) value *= 1.001;
  const CaseAssessment assessment = assess(definition, runs);
  EXPECT_EQ(assessment.gate.at(1).verdict, Verdict::inconclusive);
  EXPECT_EQ(kinds_sentence({assessment}, {}),
            "Validation rows: 1 of 2 pass; regression rows: 1 of 2. 50 % of the rows rest on an "
            "experiment (0), an exact solution (1) or a tolerance of this harness (1). 1 row has a "
            "reference whose uncertainty is unknown.");
  EXPECT_EQ(kinds_sentence({}, {}), "");
}

TEST(RowKinds, CountProblemsAsExactSolutions) {
  const ProblemGateRow order{"velocity", ProblemMetric::order_at_least, "1", 1.9, {}, "", "", {}};
  ProblemGateRow earlier = order;
  earlier.kind = RowKind::regression;
  ProblemRun run{{RunState::finished, ""}, ProblemResult{}};
  run.result->outcome.measures = {{"velocity", {{0.2, 0.04}, {0.1, 0.01}, {0.05, 0.0025}}}};
  const auto assessment = assess(ProblemDefinition{"taylor_green", {order, earlier}}, run);
  EXPECT_EQ(kinds_sentence({}, {assessment}),
            "Validation rows: 1 of 1 pass; regression rows: 1 of 1. 50 % of the rows rest on an "
            "experiment (0), an exact solution (1) or a tolerance of this harness (0). 0 rows have "
            "a reference whose uncertainty is unknown.");
}

}  // namespace
}  // namespace slosh::row_kinds_test

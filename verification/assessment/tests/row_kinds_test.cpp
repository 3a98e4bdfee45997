// What the headline says of what the rows rest on.
#include "verification/assessment/row_kinds.hpp"

#include <gtest/gtest.h>

#include "verification/tests/surge_results.hpp"

namespace slosh::row_kinds_test {
namespace {

TEST(BasisSentence, CountsTheRowsByWhatTheyRestOn) {
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
  EXPECT_EQ(basis_sentence({assessment}, {}),
            "Rows: 1 against exact solutions, 1 own tolerances, 2 regression, 0 experiments; 1 of "
            "them against a reference of unknown uncertainty.");
  EXPECT_EQ(basis_sentence({}, {}), "");
}

TEST(BasisSentence, CountsProblemsAsExactSolutions) {
  const ProblemGateRow order{"velocity", ProblemMetric::order_at_least, "1", 1.9, {}, "", "", {}};
  ProblemGateRow earlier = order;
  earlier.kind = RowKind::regression;
  ProblemRun run{{RunState::finished, ""}, ProblemResult{}};
  run.result->outcome.measures = {{"velocity", {{0.2, 0.04}, {0.1, 0.01}, {0.05, 0.0025}}}};
  const auto assessment = assess(ProblemDefinition{"taylor_green", {order, earlier}}, run);
  EXPECT_EQ(basis_sentence({}, {assessment}),
            "Rows: 1 against exact solutions, 0 own tolerances, 1 regression, 0 experiments.");
}

}  // namespace
}  // namespace slosh::row_kinds_test

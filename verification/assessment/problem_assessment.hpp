// A verification problem after its run: whether it stands, and what its gate rows say. Nothing here
// runs a solver.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "verification/assessment/case_assessment.hpp"
#include "verification/case/campaign_definition.hpp"
#include "verification/problems/problem_result.hpp"

namespace slosh {

struct ProblemRun {
  RunStatus status;
  std::optional<ProblemResult> result;  // where it has finished
};

struct ProblemGateOutcome {
  ProblemGateRow row;
  Verdict verdict;
  double value;         // NaN where there is none
  std::string message;  // "1.98 >= 1.9", or why there is nothing to judge
};

struct ProblemAssessment {
  ProblemDefinition definition;
  ProblemRun run;
  std::vector<ProblemGateOutcome> gate;  // in the order of the rows
};

// The slope of the least-squares line through (ln step, ln |error|) of the errors above zero;
// nothing where fewer than three are, or where an error is no number.
std::optional<double> order_of(const std::vector<ErrorAtStep>& errors);

// A single NaN error violates every row of the measure.
ProblemGateOutcome evaluate(const ProblemGateRow& row, const ProblemRun& run);

ProblemAssessment assess(const ProblemDefinition& definition, ProblemRun run);

// Of cases and problems together, as that of cases.
int exit_status(const std::vector<CaseAssessment>& cases,
                const std::vector<ProblemAssessment>& problems);

}  // namespace slosh

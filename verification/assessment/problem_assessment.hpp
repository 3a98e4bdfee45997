// A verification problem after its run: its status and the verdicts of its gate rows. Nothing here
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
  std::optional<ProblemResult> result;  // of a finished run
};

struct ProblemGateOutcome {
  ProblemGateRow row;
  Verdict verdict;
  double value;         // NaN where it was not measured
  std::string message;  // "1.98 >= 1.9", or why nothing could be judged
};

struct ProblemAssessment {
  ProblemDefinition definition;
  ProblemRun run;
  std::vector<ProblemGateOutcome> gate;  // in the order of the rows
};

// The slope of the least-squares line through (ln step, ln |error|) of the errors above zero.
// Returns nullopt for fewer than three such errors, and where an error is not finite.
std::optional<double> order_of(const std::vector<ErrorAtStep>& errors);

// A single NaN error violates every row of the measure.
ProblemGateOutcome evaluate(const ProblemGateRow& row, const ProblemRun& run);

ProblemAssessment assess(const ProblemDefinition& definition, ProblemRun run);

// The exit status of cases and problems together, by the rules of that of cases.
int exit_status(const std::vector<CaseAssessment>& cases,
                const std::vector<ProblemAssessment>& problems);

}  // namespace slosh

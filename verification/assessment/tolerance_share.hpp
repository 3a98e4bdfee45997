// How much of what a gate row allows its metric takes: |E| / limit; of a range from a to b
// |E - (a + b) / 2| / ((b - a) / 2); of an order that is to be reached, limit / order. Above 1 the
// bound is left; rows of any unit can be set in one order by it.
#pragma once

#include <optional>

#include "verification/assessment/problem_assessment.hpp"
#include "verification/gate/gate.hpp"

namespace slosh {

struct ToleranceShare {
  double value;
  double half_width;  // of the 95 % interval that the verdict rests on; zero where there is none
};

// None where there is no number, and of a row that is to improve on another run.
std::optional<ToleranceShare> tolerance_share(const GateOutcome& outcome);
std::optional<ToleranceShare> tolerance_share(const ProblemGateOutcome& outcome);

// Which of two verdicts tells of more trouble: solver failed, violated, not compared, inconclusive,
// pass, not supplied, not selected, the worst with the highest number.
int severity(Verdict verdict);

}  // namespace slosh

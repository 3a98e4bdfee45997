// The error of a gate row's metric over the row's tolerance: |E| / limit; for a range from a to b
// |E - (a + b) / 2| / ((b - a) / 2); for an order that must be reached, limit / order; for a
// p-value p with the lowest accepted level a, a / p above a and 2 - p / a below. The bound is
// violated above
// 1. The ratio orders rows whose units differ.
#pragma once

#include <optional>

#include "verification/assessment/problem_assessment.hpp"
#include "verification/gate/gate.hpp"

namespace slosh {

struct ErrorOverTolerance {
  double value;
  double half_width;  // of the verdict's 95 % interval, over the tolerance; zero without one
};

// Returns the half width of the 95 % interval that the verdict rests on, or else of the metric
// itself, in the row's unit.
double half_width_of(const GateOutcome& outcome);

// Returns nullopt where the metric is not finite, and for a row that demands an improvement on
// another run.
std::optional<ErrorOverTolerance> error_over_tolerance(const GateOutcome& outcome);
std::optional<ErrorOverTolerance> error_over_tolerance(const ProblemGateOutcome& outcome);

// Orders verdicts from the worst, which has the highest number: solver failed, violated, not
// compared, inconclusive, pass, not supplied, not selected.
int severity(Verdict verdict);

}  // namespace slosh

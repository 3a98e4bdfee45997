// The convergence of a scheme's errors against a reference with its spacing: each metric's values,
// their order and limit (discretisation_uncertainty.hpp), and the interval of the order. The half
// width of the order's 95 % interval is sqrt(sum d_i^2), where d_i is the largest change of the
// order when value i is moved up or down by its own half width.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "verification/assessment/case_assessment.hpp"
#include "verification/evidence/refinement.hpp"

namespace slosh {

struct ConvergedMetric {
  GateRow row;            // names the metric and the finest run; it has no bound
  RefinedMetric refined;  // coarse to fine
  // nullopt where there is no order, or where a value moved within its interval leaves none.
  std::optional<double> order_half_width;
};

std::optional<double> order_half_width(const std::vector<ValueAtStep>& values);

// Asks how `quantity` of the finest run converges against the reference.
struct ConvergenceQuestion {
  std::string finest, reference, quantity;
};

struct Convergence {
  std::vector<ConvergedMetric> metrics;
  std::vector<std::string> not_measured;  // "forced phase_lag: why"
};

// Covers the amplitude and phase of the forced mode, the frequency and decay of the natural modes,
// and the residual of the whole window (the metric table's `convergence`).
Convergence convergence_of(const CaseAssessment& assessment, const ConvergenceQuestion& question);

}  // namespace slosh

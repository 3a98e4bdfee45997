// How the errors of a scheme against a reference fall with its spacing: each metric's values, what
// discretisation_uncertainty.hpp makes of them, and how sure their order is. The order's 95 %
// interval comes from the values': with d_i the most that the order changes as value i is moved up
// or down by its half width, sqrt(sum d_i^2).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "verification/assessment/case_assessment.hpp"
#include "verification/evidence/refinement.hpp"

namespace slosh {

struct ConvergedMetric {
  GateRow row;            // of the finest run: what is measured; it has no bound
  RefinedMetric refined;  // coarse to fine
  // Of the order; none where there is no order, or where a value moved within its interval leaves
  // none.
  std::optional<double> order_half_width;
};

std::optional<double> order_half_width(const std::vector<ValueAtStep>& values);

// What is measured: `quantity` of the finest run against the reference, in that order.
struct ConvergenceQuestion {
  std::string finest, reference, quantity;
};

struct Convergence {
  std::vector<ConvergedMetric> metrics;
  std::vector<std::string> not_measured;  // "forced phase_lag: why"
};

// Of the forced mode amplitude and phase, of the natural modes frequency and decay, of the whole
// window the residual.
Convergence convergence_of(const CaseAssessment& assessment, const ConvergenceQuestion& question);

}  // namespace slosh

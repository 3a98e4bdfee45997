#include "verification/assessment/convergence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "verification/case/motion.hpp"
#include "verification/case/quantities.hpp"
#include "verification/gate/measured_value.hpp"

namespace slosh {
namespace {

// The modes and metrics whose convergence is shown.
std::vector<std::pair<std::string, Metric>> metrics_of(const CaseDefinition& definition,
                                                       const std::string& quantity) {
  std::vector<std::pair<std::string, Metric>> metrics;
  const auto add = [&](const std::string& mode, ConvergenceShown shown) {
    for (const MetricEntry& entry : metric_table())
      if (entry.convergence == shown) metrics.push_back({mode, entry.metric});
  };
  if (!has_modes(quantity)) {
    add("whole", ConvergenceShown::of_front);
    return metrics;
  }
  for (const ToneRequest& mode : fitted_modes(definition))
    add(mode.name, is_forced(mode.name) ? ConvergenceShown::of_forced_mode
                                        : ConvergenceShown::of_natural_modes);
  add("whole", ConvergenceShown::of_oscillation);
  return metrics;
}

std::optional<double> order_of(const std::vector<ValueAtStep>& values) try {
  return discretisation_uncertainty(values).order;
} catch (const ComparisonError&) {
  return {};
}

std::string why_not_measured(const GateRow& row, const MeasureRow& measure) try {
  measure(row);
  return fmt::format("fewer than three spacings have it that differ by a factor of {} or more",
                     least_refinement_ratio);
} catch (const std::runtime_error& error) {  // ComparisonError and ResultError
  return error.what();
}

}  // namespace

std::optional<double> order_half_width(const std::vector<ValueAtStep>& values) {
  const std::optional<double> order = order_of(values);
  if (!order) return {};
  double squares = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    double change = 0;
    for (const double side : {-1.0, 1.0}) {
      std::vector<ValueAtStep> moved = values;
      moved[i].value += side * moved[i].noise;
      const std::optional<double> other = order_of(moved);
      if (!other) return {};
      change = std::max(change, std::abs(*other - *order));
    }
    squares += change * change;
  }
  return std::sqrt(squares);
}

Convergence convergence_of(const CaseAssessment& assessment, const ConvergenceQuestion& question) {
  CaseEvidence evidence(assessment.definition, assessment.runs, &assessment.fitted);
  const GateEvidence given = evidence.gate_evidence();
  // The gate judges the residual of the declared window alone, without an interval; an order must
  // hold in other windows too.
  const MeasureRow measure = [&](const GateRow& row) {
    return row.metric == Metric::normalised_rms
               ? evidence.comparison(row.candidate, row.reference, row.quantity).normalised_rms
               : measured(row, given);
  };
  Convergence found;
  for (const auto& [mode, metric] : metrics_of(assessment.definition, question.quantity)) {
    GateRow row{};
    row.candidate = question.finest;
    row.reference = question.reference;
    row.quantity = question.quantity;
    row.mode = mode;
    row.metric = metric;
    row.unit = metric_unit(metric, unit_of(question.quantity));
    auto [refined, unknown] =
        refined_metrics(assessment.definition, assessment.runs, row, Role::candidate,
                        {measure, evidence.measure_with_series()});
    if (refined.empty() || refined.front().values.size() < 3) {
      found.not_measured.push_back(
          mode + " " + metric_name(metric) + ": " +
          (unknown.empty() ? why_not_measured(row, measure) : unknown.front()));
      continue;
    }
    const std::optional<double> half_width = order_half_width(refined.front().values);
    found.metrics.push_back({row, std::move(refined.front()), half_width});
  }
  return found;
}

}  // namespace slosh

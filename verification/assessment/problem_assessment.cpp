#include "verification/assessment/problem_assessment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "verification/assessment/observed_order.hpp"
#include "verification/series/time_series.hpp"

namespace slosh {
namespace {

bool all_finite(const std::vector<ErrorAtStep>& errors) {
  return std::all_of(errors.begin(), errors.end(), [](const ErrorAtStep& one) {
    return std::isfinite(one.error) && std::isfinite(one.step);
  });
}

const ErrorAtStep& finest(const std::vector<ErrorAtStep>& errors) {
  return *std::min_element(
      errors.begin(), errors.end(),
      [](const ErrorAtStep& a, const ErrorAtStep& b) { return a.step < b.step; });
}

// Throws ComparisonError where the metric has no value.
double value_of(ProblemMetric metric, const std::vector<ErrorAtStep>& errors) {
  if (errors.empty()) throw ComparisonError("the measure has no errors");
  if (!all_finite(errors)) return not_a_number;
  if (metric == ProblemMetric::error_at_finest) return std::abs(finest(errors).error);
  if (metric == ProblemMetric::largest_error) {
    double largest = 0;
    for (const ErrorAtStep& one : errors) largest = std::max(largest, std::abs(one.error));
    return largest;
  }
  const std::optional<double> order = order_of(errors);
  if (!order) throw ComparisonError("an order needs three errors above zero");
  return *order;
}

struct Bound {
  bool holds;
  std::string text;
};

// NaN satisfies no bound.
Bound compare_to_bound(const ProblemGateRow& row, double value) {
  const std::string unit = row.unit == "1" ? "" : " " + row.unit;
  if (row.metric == ProblemMetric::order_within) {
    const auto [lower, upper] = row.between.value();
    const bool holds = value >= lower && value <= upper;
    return {holds, fmt::format("{:.3g} {} {:g} to {:g}", value, holds ? "within" : "not within",
                               lower, upper)};
  }
  const double limit = row.limit.value();
  const bool at_least = row.metric == ProblemMetric::order_at_least;
  const bool holds = at_least ? value >= limit : value <= limit;
  const char* sign = at_least ? (holds ? ">=" : "not >=") : (holds ? "<=" : "not <=");
  return {holds, fmt::format("{:.3g}{} {} {:g}{}", value, unit, sign, limit, unit)};
}

}  // namespace

std::optional<double> order_of(const std::vector<ErrorAtStep>& errors) {
  if (!all_finite(errors)) return std::nullopt;
  std::vector<ErrorAtSpacing> points;
  for (const auto& [step, error] : errors) points.push_back({step, {error, 0}});
  return least_squares_order(points);
}

ProblemGateOutcome evaluate(const ProblemGateRow& row, const ProblemRun& run) {
  if (const auto found = obstacle_of("the problem", run.status))
    return {row, found->first, not_a_number, found->second};
  const std::vector<MeasuredErrors>& measures = run.result.value().outcome.measures;
  const auto found = std::find_if(measures.begin(), measures.end(), [&](const MeasuredErrors& one) {
    return one.name == row.measure;
  });
  if (found == measures.end())
    return {row, Verdict::not_compared, not_a_number, "the result has no measure " + row.measure};
  try {
    const double value = value_of(row.metric, found->errors);
    const Bound bound = compare_to_bound(row, value);
    return {row, bound.holds ? Verdict::pass : Verdict::violated, value,
            bound.text + (row.kind == RowKind::regression ? " (regression)" : "")};
  } catch (const ComparisonError& error) {
    return {row, Verdict::not_compared, not_a_number, error.what()};
  }
}

ProblemAssessment assess(const ProblemDefinition& definition, ProblemRun run) {
  ProblemAssessment assessment{definition, std::move(run), {}};
  for (const ProblemGateRow& row : definition.gate)
    assessment.gate.push_back(evaluate(row, assessment.run));
  return assessment;
}

int exit_status(const std::vector<CaseAssessment>& cases,
                const std::vector<ProblemAssessment>& problems) {
  Standing standing = standing_of(cases);
  for (const ProblemAssessment& one : problems) {
    standing.run_failed |= one.run.status.state == RunState::failed;
    standing.left_open |= one.run.status.state == RunState::missing;
    for (const ProblemGateOutcome& outcome : one.gate) standing.verdicts.push_back(outcome.verdict);
  }
  return exit_status(standing);
}

}  // namespace slosh

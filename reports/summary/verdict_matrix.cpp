#include "reports/summary/verdict_matrix.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <tuple>
#include <variant>

#include "reports/tables/case_tables.hpp"
#include "reports/wording/report_places.hpp"
#include "verification/case/campaign_definition.hpp"
#include "verification/series/time_series.hpp"

namespace slosh {
namespace {

std::string found_text(const ProblemGateOutcome& outcome) {
  if (!std::isfinite(outcome.value)) return "";
  const std::string& unit = outcome.row.unit;
  return fmt::format("{:.3g}{}", outcome.value, unit == "1" ? "" : " " + unit);
}

bool is_of_mesh(const CaseDefinition& definition, const std::string& run) {
  return std::any_of(definition.runs.begin(), definition.runs.end(), [&](const auto& one) {
    return one.name == run && std::holds_alternative<InterFoamRun>(one.solver);
  });
}

}  // namespace

double ShownRow::reach() const {
  if (share) return share->value + share->half_width;
  return verdict == Verdict::pass ? -1 : std::numeric_limits<double>::infinity();
}

bool is_worse(const ShownRow& one, const ShownRow& other) {
  if (one.verdict != other.verdict) return severity(one.verdict) > severity(other.verdict);
  return one.reach() > other.reach();
}

std::vector<ShownRow> shown_rows(const CaseAssessment& one) {
  std::vector<ShownRow> rows;
  for (std::size_t i = 0; i < one.gate.size(); ++i) {
    const GateOutcome& outcome = one.gate[i];
    const GateRow& row = outcome.row;
    const double half_width = half_width_of(outcome);
    rows.push_back({.name = one.definition.name,
                    .candidate = row.candidate,
                    .reference = row.reference,
                    .shown_reference = reference_text(row),
                    .of_mesh = is_of_mesh(one.definition, row.candidate),
                    .regression = row.kind == RowKind::regression,
                    .metric = metric_name(row.metric),
                    .metric_text = metric_text(row),
                    .verdict = outcome.verdict,
                    .value = outcome.value.value,
                    .half_width = half_width,
                    .unit = row.unit,
                    .found = std::isfinite(outcome.value.value)
                                 ? value_text(row, {outcome.value.value, half_width})
                                 : "",
                    .message = outcome.message,
                    .remedy = remedy_text(one.definition, outcome),
                    .row_id = case_row_id(one.definition.name, i),
                    .share = error_over_tolerance(outcome)});
  }
  return rows;
}

std::vector<ShownRow> shown_rows(const std::vector<CaseAssessment>& cases) {
  std::vector<ShownRow> rows;
  for (const CaseAssessment& one : cases)
    std::ranges::move(shown_rows(one), std::back_inserter(rows));
  return rows;
}

std::vector<ShownRow> shown_rows(const std::vector<ProblemAssessment>& problems) {
  std::vector<ShownRow> rows;
  for (const ProblemAssessment& one : problems)
    for (std::size_t i = 0; i < one.gate.size(); ++i) {
      const ProblemGateOutcome& outcome = one.gate[i];
      rows.push_back({.name = one.definition.name,
                      .candidate = outcome.row.measure,
                      .reference = "exact solution",
                      .shown_reference = "exact solution",
                      .regression = outcome.row.kind == RowKind::regression,
                      .metric = metric_name(outcome.row.metric),
                      .metric_text = metric_name(outcome.row.metric),
                      .verdict = outcome.verdict,
                      .value = outcome.value,
                      .half_width = not_a_number,
                      .unit = outcome.row.unit,
                      .found = found_text(outcome),
                      .message = outcome.message,
                      .remedy = {},
                      .row_id = problem_row_id(one.definition.name, i),
                      .share = error_over_tolerance(outcome)});
    }
  return rows;
}

VerdictMatrix verdict_matrix(const std::vector<ShownRow>& rows) {
  VerdictMatrix matrix;
  for (const ShownRow& one : rows) {
    if (std::find(matrix.metrics.begin(), matrix.metrics.end(), one.metric) == matrix.metrics.end())
      matrix.metrics.push_back(one.metric);
    auto row = std::find_if(matrix.rows.begin(), matrix.rows.end(), [&](const MatrixRow& other) {
      return std::tie(other.name, other.candidate, other.shown_reference) ==
             std::tie(one.name, one.candidate, one.shown_reference);
    });
    if (row == matrix.rows.end())
      row = matrix.rows.insert(row,
                               {one.name, one.candidate, one.reference, one.shown_reference, {}});
    MatrixCell& cell = row->cells[one.metric];
    if (++cell.rows == 1 || is_worse(one, cell.worst)) cell.worst = one;
  }
  return matrix;
}

}  // namespace slosh

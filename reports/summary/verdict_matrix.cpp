#include "reports/summary/verdict_matrix.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "reports/wording/report_places.hpp"
#include "verification/case/campaign_definition.hpp"
#include "verification/series/time_series.hpp"

namespace slosh {
namespace {

// The cell of the higher rank is the worse one.
std::pair<int, double> rank(const MatrixCell& cell) {
  return {severity(cell.verdict), cell.share ? cell.share->value : -1};
}

// The contribution of one gate row to the matrix.
struct Entry {
  std::string name, candidate, reference, metric;
  MatrixCell cell;
};

void add(Entry entry, VerdictMatrix& matrix) {
  if (std::find(matrix.metrics.begin(), matrix.metrics.end(), entry.metric) == matrix.metrics.end())
    matrix.metrics.push_back(entry.metric);
  auto row = std::find_if(matrix.rows.begin(), matrix.rows.end(), [&](const MatrixRow& one) {
    return std::tie(one.name, one.candidate, one.reference) ==
           std::tie(entry.name, entry.candidate, entry.reference);
  });
  if (row == matrix.rows.end())
    row = matrix.rows.insert(row, {entry.name, entry.candidate, entry.reference, {}});
  MatrixCell& standing = row->cells[entry.metric];
  const std::size_t rows = standing.rows + 1;
  if (rows == 1 || rank(entry.cell) > rank(standing)) standing = std::move(entry.cell);
  standing.rows = rows;
}

// Returns "-0.3 ± 0.6 %".
std::string found_text(const GateRow& row, double value, double half_width) {
  if (!std::isfinite(value)) return "";
  const double scale = row.unit == "1" ? 100 : 1;
  const std::string interval =
      half_width > 0 ? fmt::format(" ± {:.2g}", scale * half_width) : std::string();
  return fmt::format("{:.3g}{} {}", scale * value, interval, row.unit == "1" ? "%" : row.unit);
}

std::string found_text(const ProblemGateOutcome& outcome) {
  if (!std::isfinite(outcome.value)) return "";
  const std::string& unit = outcome.row.unit;
  return fmt::format("{:.3g}{}", outcome.value, unit == "1" ? "" : " " + unit);
}

std::string cell_text(const MatrixCell& cell) {
  std::string rest = cell.found;
  if (cell.rows > 1) rest += fmt::format("{}worst of {}", rest.empty() ? "" : ", ", cell.rows);
  return verdict_name(cell.verdict) + (rest.empty() ? "" : ": " + rest);
}

bool is_left_out(const MatrixRow& row) {
  return std::all_of(row.cells.begin(), row.cells.end(),
                     [](const auto& cell) { return cell.second.verdict == Verdict::not_selected; });
}

std::string heading(std::string metric) {
  std::replace(metric.begin(), metric.end(), '_', ' ');
  return metric;
}

}  // namespace

VerdictMatrix verdict_matrix(const std::vector<CaseAssessment>& cases) {
  VerdictMatrix matrix;
  for (const CaseAssessment& one : cases)
    for (std::size_t i = 0; i < one.gate.size(); ++i) {
      const GateOutcome& outcome = one.gate[i];
      const GateRow& row = outcome.row;
      const double half_width =
          outcome.judgement ? outcome.judgement->uncertainty : outcome.value.half_width;
      add({one.definition.name,
           row.candidate,
           row.reference,
           metric_name(row.metric),
           {.rows = 1,
            .verdict = outcome.verdict,
            .value = outcome.value.value,
            .half_width = half_width,
            .unit = row.unit,
            .found = found_text(row, outcome.value.value, half_width),
            .row_id = case_row_id(one.definition.name, i),
            .share = error_over_tolerance(outcome)}},
          matrix);
    }
  return matrix;
}

VerdictMatrix verdict_matrix(const std::vector<ProblemAssessment>& problems) {
  VerdictMatrix matrix;
  for (const ProblemAssessment& one : problems)
    for (std::size_t i = 0; i < one.gate.size(); ++i) {
      const ProblemGateOutcome& outcome = one.gate[i];
      add({one.definition.name,
           outcome.row.measure,
           "exact solution",
           metric_name(outcome.row.metric),
           {.rows = 1,
            .verdict = outcome.verdict,
            .value = outcome.value,
            .half_width = not_a_number,
            .unit = outcome.row.unit,
            .found = found_text(outcome),
            .row_id = problem_row_id(one.definition.name, i),
            .share = error_over_tolerance(outcome)}},
          matrix);
    }
  return matrix;
}

reports::Table matrix_table(const VerdictMatrix& matrix, const std::string& id,
                            const std::string& title, const std::string& of) {
  reports::Table table{
      id,
      title,
      "Each cell shows the worst gate row of that pair and metric, its value and the half "
      "width of its 95 % interval, and links to the row.",
      {of, "candidate", "reference"},
      {}};
  for (const std::string& metric : matrix.metrics) table.header.push_back(heading(metric));
  std::size_t pairs_left_out = 0;
  for (const MatrixRow& row : matrix.rows) {
    if (is_left_out(row)) {
      ++pairs_left_out;
      continue;
    }
    std::vector<std::string> cells{row.name, row.candidate,
                                   row.reference.empty() ? "none" : row.reference},
        links(3);
    for (const std::string& metric : matrix.metrics) {
      const auto found = row.cells.find(metric);
      const bool is_there = found != row.cells.end();
      cells.push_back(is_there ? cell_text(found->second) : "");
      links.push_back(is_there ? "row-" + found->second.row_id : "");
    }
    table.rows.push_back(std::move(cells));
    table.links.push_back(std::move(links));
  }
  if (pairs_left_out > 0)
    table.caption +=
        pairs_left_out == 1
            ? " 1 pair without a selected row is left out."
            : fmt::format(" {} pairs without a selected row are left out.", pairs_left_out);
  return table;
}

}  // namespace slosh

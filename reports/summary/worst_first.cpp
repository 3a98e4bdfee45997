#include "reports/summary/worst_first.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "reports/tables/case_tables.hpp"
#include "reports/wording/report_places.hpp"
#include "verification/assessment/error_over_tolerance.hpp"
#include "verification/case/campaign_definition.hpp"

namespace slosh {
namespace {

struct Judged {
  Verdict verdict;
  std::optional<ErrorOverTolerance> share;
  std::vector<std::string> cells;  // case, candidate, reference, metric, result
  std::string row_id;
};

bool counts(Verdict verdict) {
  return verdict != Verdict::not_selected && verdict != Verdict::not_supplied;
}

// Returns the far end of the interval as a share of the tolerance.
double reach(const Judged& row) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (row.share) return row.share->value + row.share->half_width;
  return row.verdict == Verdict::pass ? -1 : infinity;
}

bool is_worse(const Judged& one, const Judged& other) {
  if (one.verdict != other.verdict) return severity(one.verdict) > severity(other.verdict);
  return reach(one) > reach(other);
}

// Returns the judged rows, worst first.
std::vector<Judged> judged_rows(const std::vector<CaseAssessment>& cases,
                                const std::vector<ProblemAssessment>& problems) {
  std::vector<Judged> rows;
  for (const CaseAssessment& one : cases)
    for (std::size_t i = 0; i < one.gate.size(); ++i) {
      const GateOutcome& outcome = one.gate[i];
      const GateRow& row = outcome.row;
      if (counts(outcome.verdict))
        rows.push_back(
            {outcome.verdict,
             error_over_tolerance(outcome),
             {one.definition.name, row.candidate, row.reference.empty() ? "none" : row.reference,
              metric_text(row), outcome.message},
             case_row_id(one.definition.name, i)});
    }
  for (const ProblemAssessment& one : problems)
    for (std::size_t i = 0; i < one.gate.size(); ++i) {
      const ProblemGateOutcome& outcome = one.gate[i];
      if (counts(outcome.verdict))
        rows.push_back({outcome.verdict,
                        error_over_tolerance(outcome),
                        {one.definition.name, outcome.row.measure, "exact solution",
                         metric_name(outcome.row.metric), outcome.message},
                        problem_row_id(one.definition.name, i)});
    }
  std::stable_sort(rows.begin(), rows.end(), is_worse);
  return rows;
}

std::string share_text(const std::optional<ErrorOverTolerance>& share) {
  if (!share) return "";
  return fmt::format("{:.0f}", 100 * share->value) +
         (share->half_width > 0 ? fmt::format(" ± {:.0f}", 100 * share->half_width) : "");
}

}  // namespace

reports::Table worst_first_table(const std::vector<CaseAssessment>& cases,
                                 const std::vector<ProblemAssessment>& problems,
                                 std::size_t fewest) {
  const std::vector<Judged> rows = judged_rows(cases, problems);
  reports::Table table{
      "worst",
      "Gate rows, worst first",
      "",
      {"verdict", "error over tolerance [%]", "case", "candidate", "reference", "metric", "result"},
      {}};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Judged& row = rows[i];
    if (row.verdict == Verdict::pass && i >= fewest) continue;
    table.rows.push_back({verdict_name(row.verdict), share_text(row.share)});
    table.rows.back().insert(table.rows.back().end(), row.cells.begin(), row.cells.end());
    table.links.push_back({"row-" + row.row_id, "", "", "", "", "", ""});
  }
  table.caption = fmt::format(
      "The rows are sorted by verdict, then by the error as a share of the tolerance, taken at the "
      "far end of the 95 % interval that the verdict uses. Above 100 % the error is outside its "
      "tolerance. The table has {} of the {} rows that were judged.",
      table.rows.size() == rows.size() ? "all" : fmt::format("{}", table.rows.size()), rows.size());
  return table;
}

reports::Link deciding_row(const std::vector<CaseAssessment>& cases,
                           const std::vector<ProblemAssessment>& problems) {
  const std::vector<Judged> rows = judged_rows(cases, problems);
  if (rows.empty() || rows.front().verdict == Verdict::pass ||
      exit_status_of({rows.front().verdict}) != exit_status(cases, problems))
    return {};
  const std::vector<std::string>& cells = rows.front().cells;
  return {fmt::format("{}: {}, {}", cells[0], cells[1], cells[3]), "row-" + rows.front().row_id};
}

}  // namespace slosh

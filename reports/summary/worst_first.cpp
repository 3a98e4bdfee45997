#include "reports/summary/worst_first.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <optional>

#include "reports/summary/verdict_matrix.hpp"
#include "reports/wording/report_places.hpp"
#include "verification/assessment/error_over_tolerance.hpp"
#include "verification/series/interval_text.hpp"

namespace slosh {
namespace {

// Returns the judged rows, worst first.
std::vector<ShownRow> judged_rows(const std::vector<CaseAssessment>& cases,
                                  const std::vector<ProblemAssessment>& problems) {
  std::vector<ShownRow> rows = shown_rows(cases);
  std::ranges::move(shown_rows(problems), std::back_inserter(rows));
  std::erase_if(rows, [](const ShownRow& row) { return !row.counts(); });
  std::stable_sort(rows.begin(), rows.end(), is_worse);
  return rows;
}

reports::Link link_to(const ShownRow& row) {
  return {fmt::format("{}: {}, {}", row.name, row.candidate, row.metric_text), "row-" + row.row_id};
}

bool is_troubled(const RunStatus& status) {
  return status.state == RunState::failed || status.state == RunState::missing;
}

// The first failed run, or else the first without a result.
reports::Decision deciding_run(const std::vector<CaseAssessment>& cases,
                               const std::vector<ProblemAssessment>& problems) {
  reports::Decision found;
  bool failed = false;
  const auto take = [&](const std::string& name, const std::string& section,
                        const RunStatus& status) {
    const bool fails = status.state == RunState::failed;
    if (!is_troubled(status) || (!found.row.text.empty() && (failed || !fails))) return;
    failed = fails;
    found = {"Decided by",
             {name, "section-" + section},
             fmt::format("{}: {}.", state_name(status.state), status.message)};
  };
  for (const CaseAssessment& one : cases)
    for (const auto& [run, status] : one.runs.status)
      take(one.definition.name + "/" + run, case_id(one.definition.name) + "-gate", status);
  for (const ProblemAssessment& one : problems)
    take(one.definition.name, "problem-" + one.definition.name, one.run.status);
  return found;
}

std::string share_text(const std::optional<ErrorOverTolerance>& share) {
  if (!share) return "";
  return interval_text({100 * share->value, 100 * share->half_width});
}

}  // namespace

reports::Table worst_first_table(const std::vector<CaseAssessment>& cases,
                                 const std::vector<ProblemAssessment>& problems,
                                 std::size_t fewest) {
  const std::vector<ShownRow> rows = judged_rows(cases, problems);
  reports::Table table{
      "worst",
      "Gate rows, worst first",
      "",
      {"verdict", "error over tolerance [%]", "case", "candidate", "reference", "metric", "result"},
      {}};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const ShownRow& row = rows[i];
    if (row.verdict == Verdict::pass && i >= fewest) continue;
    table.rows.push_back({verdict_name(row.verdict), share_text(row.share), row.name, row.candidate,
                          row.shown_reference, row.metric_text, row.message});
    table.links.push_back({"row-" + row.row_id, "", "", "", "", "", ""});
  }
  table.caption = fmt::format(
      "The rows are sorted by verdict, then by the error as a share of the tolerance, taken at the "
      "far end of the 95 % interval that the verdict uses. Above 100 % the error is outside its "
      "tolerance. The table has {} of the {} rows that were judged.",
      table.rows.size() == rows.size() ? "all" : fmt::format("{}", table.rows.size()), rows.size());
  return table;
}

reports::Decision decision_of(const std::vector<CaseAssessment>& cases,
                              const std::vector<ProblemAssessment>& problems) {
  const std::vector<ShownRow> rows = judged_rows(cases, problems);
  const int status = exit_status(cases, problems);
  if (status == exit_pass) {
    const auto nearest = std::find_if(rows.begin(), rows.end(),
                                      [](const ShownRow& row) { return row.share.has_value(); });
    return nearest == rows.end()
               ? reports::Decision{}
               : reports::Decision{"Nearest to its limit is", link_to(*nearest),
                                   fmt::format("{} ({} % of the tolerance).", nearest->message,
                                               share_text(nearest->share))};
  }
  if (rows.empty() || exit_status_of({rows.front().verdict}) != status ||
      status == exit_solver_failed)
    return deciding_run(cases, problems);
  // interFoam is the reference of most rows: what a code under test does wrong is told first.
  const auto of_tested_code = std::find_if(rows.begin(), rows.end(), [&](const ShownRow& row) {
    return row.verdict == rows.front().verdict && !row.of_mesh;
  });
  const ShownRow& worst = of_tested_code == rows.end() ? rows.front() : *of_tested_code;
  return {"Decided by", link_to(worst),
          worst.message + "." +
              (worst.remedy.empty() ? "" : " What would decide it: " + worst.remedy + ".")};
}

std::string worst_candidate(const CaseAssessment& assessment) {
  const std::vector<ShownRow> rows = judged_rows({assessment}, {});
  return rows.empty() ? "" : rows.front().candidate;
}

}  // namespace slosh

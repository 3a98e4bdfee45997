#include "reports/summary/shown_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <limits>

#include "reports/tables/case_tables.hpp"
#include "reports/wording/case_text.hpp"
#include "verification/series/interval_text.hpp"

namespace slosh {
namespace {

// Returns the judged rows, worst first.
std::vector<ShownRow> judged_rows(const std::vector<CaseAssessment>& cases,
                                  const std::vector<ProblemAssessment>& problems) {
  std::vector<ShownRow> rows;
  for (const CaseAssessment& one : cases)
    std::ranges::move(shown_rows(one), std::back_inserter(rows));
  for (const ProblemAssessment& one : problems)
    std::ranges::move(shown_rows(one), std::back_inserter(rows));
  std::erase_if(rows, [](const ShownRow& row) { return !row.counts(); });
  std::ranges::stable_sort(rows, is_worse);
  return rows;
}

reports::Link link_to(const ShownRow& row) {
  return {fmt::format("{}: {}, {}", row.name, row.candidate, row.metric_text), "row-" + row.row_id};
}

// The first failed run, or else the first without a result.
reports::Decision deciding_run(const std::vector<CaseAssessment>& cases,
                               const std::vector<ProblemAssessment>& problems) {
  reports::Decision failed, missing;
  const auto take = [&](const std::string& name, const std::string& section,
                        const RunStatus& status) {
    if (status.state != RunState::failed && status.state != RunState::missing) return;
    reports::Decision& first = status.state == RunState::failed ? failed : missing;
    if (first.row.text.empty())
      first = {"Decided by",
               {name, "section-" + section},
               fmt::format("{}: {}.", state_name(status.state), status.message)};
  };
  for (const CaseAssessment& one : cases)
    for (const auto& [run, status] : one.runs.status)
      take(one.definition.name + "/" + run, case_id(one.definition.name) + "-gate", status);
  for (const ProblemAssessment& one : problems)
    take(one.definition.name, "problem-" + one.definition.name, one.run.status);
  return failed.row.text.empty() ? missing : failed;
}

std::string share_text(const std::optional<ErrorOverTolerance>& share) {
  return share ? interval_text({100 * share->value, 100 * share->half_width}) : "";
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

std::vector<ShownRow> shown_rows(const CaseAssessment& assessment) {
  const CaseDefinition& definition = assessment.definition;
  std::vector<ShownRow> rows;
  for (const GateOutcome& outcome : assessment.gate) {
    const GateRow& row = outcome.row;
    const bool of_mesh = std::ranges::any_of(definition.runs, [&](const RunDefinition& run) {
      return run.name == row.candidate && std::holds_alternative<InterFoamRun>(run.solver);
    });
    rows.push_back({.name = definition.name,
                    .candidate = row.candidate,
                    .reference = reference_text(row),
                    .outcome = &outcome,
                    .of_mesh = of_mesh,
                    .regression = row.kind == RowKind::regression,
                    .metric = metric_name(row.metric),
                    .metric_text = metric_text(row),
                    .verdict = outcome.verdict,
                    .value = outcome.value.value,
                    .half_width = half_width_of(outcome),
                    .unit = row.unit,
                    .message = outcome.message,
                    .row_id = case_row_id(definition.name, rows.size()),
                    .share = error_over_tolerance(outcome)});
  }
  return rows;
}

std::vector<ShownRow> shown_rows(const ProblemAssessment& assessment) {
  const std::string& name = assessment.definition.name;
  std::vector<ShownRow> rows;
  for (const ProblemGateOutcome& outcome : assessment.gate)
    rows.push_back({.name = name,
                    .candidate = outcome.row.measure,
                    .reference = "exact solution",
                    .regression = outcome.row.kind == RowKind::regression,
                    .metric = metric_name(outcome.row.metric),
                    .metric_text = metric_name(outcome.row.metric),
                    .verdict = outcome.verdict,
                    .value = outcome.value,
                    .half_width = not_a_number,
                    .unit = outcome.row.unit,
                    .message = outcome.message,
                    .row_id = problem_row_id(name, rows.size()),
                    .share = error_over_tolerance(outcome)});
  return rows;
}

reports::Table worst_first_table(const std::vector<CaseAssessment>& cases,
                                 const std::vector<ProblemAssessment>& problems,
                                 std::size_t fewest) {
  const std::vector<ShownRow> rows = judged_rows(cases, problems);
  reports::Table table{"worst",
                       "Gate rows, worst first",
                       "",
                       {"verdict", "error over tolerance [%]", "case", "candidate", "reference",
                        "metric", "result"}};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const ShownRow& row = rows[i];
    if (row.verdict == Verdict::pass && i >= fewest) continue;
    table.rows.push_back({verdict_name(row.verdict), share_text(row.share), row.name, row.candidate,
                          row.reference, row.metric_text, row.message});
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
    const auto nearest =
        std::ranges::find_if(rows, [](const ShownRow& row) { return row.share.has_value(); });
    if (nearest == rows.end()) return {};
    return {
        "Nearest to its limit is", link_to(*nearest),
        fmt::format("{} ({} % of the tolerance).", nearest->message, share_text(nearest->share))};
  }
  if (rows.empty() || exit_status_of({rows.front().verdict}) != status ||
      status == exit_solver_failed)
    return deciding_run(cases, problems);
  // interFoam is the reference of most rows: what a code under test does wrong is told first.
  const auto of_tested_code = std::ranges::find_if(rows, [&](const ShownRow& row) {
    return row.verdict == rows.front().verdict && !row.of_mesh;
  });
  const ShownRow& worst = of_tested_code == rows.end() ? rows.front() : *of_tested_code;
  std::string remedy;
  if (worst.outcome) {
    const auto name = [](const CaseAssessment& one) { return one.definition.name; };
    remedy = remedy_text(std::ranges::find(cases, worst.name, name)->definition, *worst.outcome);
  }
  return {"Decided by", link_to(worst),
          worst.message + "." + (remedy.empty() ? "" : " What would decide it: " + remedy + ".")};
}

std::string worst_candidate(const CaseAssessment& assessment) {
  const std::vector<ShownRow> rows = judged_rows({assessment}, {});
  return rows.empty() ? "" : rows.front().candidate;
}

}  // namespace slosh

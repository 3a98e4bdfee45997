#include <fmt/format.h>
#include <fmt/ranges.h>

#include "reports/tables/case_tables.hpp"
#include "verification/assessment/across_runs/panels.hpp"
#include "verification/gate/gate.hpp"
#include "verification/series/interval_text.hpp"

namespace slosh {
namespace {

using reports::Table;
using Row = std::vector<std::string>;

// "7210 ± 830 (sd 520, 4)": the mean of 4 members with its 95 % interval and their deviation.
std::string solver_cell(const PanelSolver& solver) {
  const std::size_t found = solver.values.size();
  const std::string never =
      solver.without_value == 0
          ? ""
          : fmt::format("; never in {} of {}", solver.without_value, found + solver.without_value);
  if (!solver.mean) return fmt::format("left out: {} usable", found) + never;
  const double deviation = solver.mean->deviation;
  return fmt::format(
      "{} (sd {}, {}){}", interval_text(solver.mean->estimate()),
      deviation >= 10 ? fmt::format("{:.0f}", deviation) : fmt::format("{:.2g}", deviation), found,
      never);
}

std::string odd_text(const PanelRow& row, const PanelSolver& odd) {
  const SolverApart& apart = row.verdict->each[*row.verdict->odd];
  return fmt::format(
      "{}: {} from the others' mean (p {:.2g}); the others agree (p {:.2g}); as one more solver of "
      "their kind p {:.2g}",
      odd.run, with_interval(apart.difference, row.unit), apart.corrected_p, apart.others_agree_p,
      apart.further_solver_p);
}

std::string apart_cell(const PanelRow& row) {
  if (!row.verdict) return "too few solvers";
  const PanelVerdict& verdict = *row.verdict;
  if (verdict.all_agree()) return fmt::format("nobody: all agree (p {:.2g})", verdict.agree_p);
  if (const PanelSolver* odd = row.odd()) return odd_text(row, *odd);
  const std::string differ = fmt::format("they differ (p {:.2g})", verdict.agree_p);
  if (row.judged.size() < fewest_solvers)
    return differ + ", and of two solvers neither can be named";
  if (verdict.apart.empty()) return differ + ", and none is apart from others that agree";
  std::vector<std::string> names;
  for (const std::size_t j : verdict.apart) names.push_back(row.solvers[row.judged[j]].run);
  return fmt::format("{}; {} could each be the one apart", differ, fmt::join(names, " and "));
}

std::string air_cell(const PanelRow& row) {
  if (!row.air_share) return "not known";
  return with_interval(*row.air_share, panel_metric_entry(row.metric).has_zero ? "1" : row.unit);
}

std::string left_out_cell(const PanelRow& row) {
  Row reasons;
  for (const PanelSolver& solver : row.solvers)
    reasons.insert(reasons.end(), solver.left_out.begin(), solver.left_out.end());
  return fmt::format("{}", fmt::join(reasons, "; "));
}

std::string caption(const PanelDefinition& panel) {
  std::string text = fmt::format(
      "{} The members of each run by themselves, none of them a reference: the mean with its 95 % "
      "interval, and in brackets the standard deviation and the number of members. A run with "
      "fewer than {} members is left out. All agree where the means scatter no more than their "
      "members let expect (p of 5 % or more). One is apart where the others agree and it alone "
      "differs from their weighted mean, after Holm's correction for the number of runs. Each row "
      "stands for itself: of equal solvers two or three rows in a hundred name one. The last p "
      "judges whether one more solver of the same kind as the others would lie so far from them; "
      "above 5 % the named run is apart from these others, but not from solvers in general.",
      panel.reason, fewest_members);
  if (panel.air)
    text += fmt::format(
        " Compressibility of the air: `{0}` less `{1}`, over `{1}`; of a time the difference.",
        panel.air->compressible, panel.air->incompressible);
  return text;
}

Table panel_table(const std::string& case_name, const PanelAssessment& panel) {
  Table table{case_name + "-panel-" + panel.definition.name,
              fmt::format("Panel {}: {}", panel.definition.name, panel.definition.quantity),
              caption(panel.definition),
              {"part", "metric"},
              {}};
  table.header.insert(table.header.end(), panel.definition.runs.begin(),
                      panel.definition.runs.end());
  table.header.push_back("who is apart");
  if (panel.definition.air) table.header.push_back("compressibility of the air");
  table.header.push_back("left out (reason)");
  for (const PanelRow& row : panel.rows) {
    table.rows.push_back(
        {row.mode == "whole" ? std::string("whole") : row.mode,
         fmt::format("{} [{}]", panel_metric_entry(row.metric).description, row.unit)});
    for (const PanelSolver& solver : row.solvers) table.rows.back().push_back(solver_cell(solver));
    table.rows.back().push_back(apart_cell(row));
    if (panel.definition.air) table.rows.back().push_back(air_cell(row));
    table.rows.back().push_back(left_out_cell(row));
  }
  return table;
}

}  // namespace

std::vector<Table> panel_tables(const CaseAssessment& assessment) {
  std::vector<Table> tables;
  for (const PanelAssessment& panel : panels_of(assessment))
    tables.push_back(panel_table(assessment.definition.name, panel));
  return tables;
}

}  // namespace slosh

#include "verification/assessment/across_runs/panels.hpp"

#include <fmt/format.h>

#include <cmath>

#include "verification/assessment/across_runs/panel_values.hpp"
#include "verification/case/ensemble.hpp"
#include "verification/case/quantities.hpp"
#include "verification/series/windowed_series.hpp"

namespace slosh {
namespace {

const TimeSeries& series_of(const CaseAssessment& assessment, const std::string& run,
                            const std::string& quantity) {
  const auto result = assessment.runs.results.find(run);
  if (result == assessment.runs.results.end())
    throw ResultError(state_name(assessment.runs.status.at(run).state));
  return result->second.at(quantity);
}

// The usable histories of all members, by solver.
std::vector<std::vector<TimeSeries>> histories(const CaseAssessment& assessment,
                                               const PanelDefinition& panel) {
  const CaseDefinition& definition = assessment.definition;
  std::vector<std::vector<TimeSeries>> solvers;
  for (const std::string& run : panel.runs) {
    solvers.emplace_back();
    for (const std::string& member : members_of(definition, run)) {
      try {
        solvers.back().push_back(cut_to_window(series_of(assessment, member, panel.quantity),
                                               {definition.window_begin, definition.window_end}));
      } catch (const std::runtime_error&) {
        continue;  // ResultError and ComparisonError: panel_solver() tells why
      }
    }
  }
  return solvers;
}

PanelSolver panel_solver(const CaseAssessment& assessment, const PanelQuestion& question,
                         const std::string& run) {
  PanelSolver solver;
  solver.run = run;
  for (const std::string& member : members_of(assessment.definition, run)) {
    try {
      const double value =
          panel_value(question, series_of(assessment, member, question.panel.quantity));
      if (std::isfinite(value))
        solver.values.push_back(value);
      else
        ++solver.without_value;
    } catch (const std::runtime_error& error) {  // ResultError and ComparisonError
      solver.left_out.push_back(fmt::format("{} ({})", member, error.what()));
    }
  }
  if (solver.values.size() >= fewest_members) solver.mean = solver_mean(solver.values);
  return solver;
}

const PanelSolver& solver_of(const PanelRow& row, const std::string& run) {
  for (const PanelSolver& one : row.solvers)
    if (one.run == run) return one;
  throw std::logic_error("the panel has no run " + run);
}

void judge(PanelRow& row, const PanelDefinition& panel) {
  std::vector<SolverMean> means;
  for (std::size_t i = 0; i < row.solvers.size(); ++i) {
    if (!row.solvers[i].mean) continue;
    means.push_back(*row.solvers[i].mean);
    row.judged.push_back(i);
  }
  if (means.size() >= 2) row.verdict = judge_panel(means);
  if (!panel.air) return;
  const auto& with = solver_of(row, panel.air->compressible).mean;
  const auto& without = solver_of(row, panel.air->incompressible).mean;
  if (!with || !without) return;
  row.air_share = panel_metric_entry(row.metric).has_zero ? ratio_less_one(*with, *without)
                                                          : difference_of(*with, *without);
}

PanelAssessment assess_panel(const CaseAssessment& assessment, const PanelDefinition& panel) {
  const CaseDefinition& definition = assessment.definition;
  PanelAssessment found{panel, {}};
  std::optional<TimeSeries> history;
  const auto add = [&](PanelMetric metric, const std::string& mode) {
    PanelRow row{mode, metric, panel_unit(metric, unit_of(panel.quantity)), {}};
    for (const std::string& run : panel.runs)
      row.solvers.push_back(panel_solver(
          assessment, {definition, panel, metric, mode, history ? &*history : nullptr}, run));
    judge(row, panel);
    found.rows.push_back(std::move(row));
  };
  const std::size_t impacts = definition.impacts ? definition.impacts->times.size() : 0;
  for (std::size_t n = 0; n < impacts; ++n)
    for (const PanelMetric metric : panel.metrics)
      if (panel_metric_entry(metric).of_each_impact) add(metric, fmt::format("impact_{}", n + 1));
  for (const PanelMetric metric : panel.metrics) {
    if (panel_metric_entry(metric).of_each_impact) continue;
    if (metric == PanelMetric::lag) {
      try {
        history = mean_history(histories(assessment, panel));
      } catch (const ComparisonError&) {
        history.reset();
      }
    }
    add(metric, "whole");
  }
  return found;
}

}  // namespace

std::string panel_finding(const PanelRow& row) {
  if (!row.verdict) return "too few solvers";
  if (row.verdict->all_agree()) return "all agree";
  if (row.verdict->odd) return "one apart";
  return row.verdict->apart.empty() ? "differ" : "several could be apart";
}

std::vector<PanelAssessment> panels_of(const CaseAssessment& assessment) {
  std::vector<PanelAssessment> panels;
  for (const PanelDefinition& panel : assessment.definition.panels)
    panels.push_back(assess_panel(assessment, panel));
  return panels;
}

}  // namespace slosh

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include "reports/figures/case_figures.hpp"
#include "reports/summary/report_sections.hpp"
#include "reports/tables/case_tables.hpp"
#include "reports/wording/case_text.hpp"
#include "verification/assessment/observed_order.hpp"
#include "verification/case/campaign_definition.hpp"
#include "verification/problems/problem_list.hpp"

namespace slosh {
namespace {

using reports::Table;

std::string order_text(const std::optional<double>& order) {
  return order ? fmt::format("{:.2f}", *order) : "none";
}

Table error_table(const Problem& problem, const ProblemResult& result) {
  Table table{
      problem.name + "-errors",
      "Errors and observed orders",
      "From the coarsest to the finest resolution. Where the steps are resolutions: the orders "
      "between neighbouring ones and the slope of the least-squares line through all.",
      {"error measure", "meaning", "step", "steps", "errors", "unit", "orders", "order"}};
  for (const MeasuredErrors& measure : result.outcome.measures) {
    std::vector<std::string> steps, errors, orders;
    std::optional<ErrorAtSpacing> coarser;
    for (const ErrorAtStep& one : measure.errors) {
      const ErrorAtSpacing finer{one.step, {one.error, 0}};
      steps.push_back(fmt::format("{:.4g}", one.step));
      errors.push_back(fmt::format("{:.3g}", one.error));
      if (coarser) orders.push_back(order_text(observed_order(*coarser, finer)));
      coarser = finer;
    }
    const auto joined = [](const auto& texts) { return fmt::format("{}", fmt::join(texts, "; ")); };
    for (const MeasureKind& kind : problem.measures)
      if (kind.name == measure.name)
        table.rows.push_back({measure.name, kind.meaning, kind.step, joined(steps), joined(errors),
                              kind.unit, kind.has_order ? joined(orders) : "",
                              kind.has_order ? order_text(order_of(measure.errors)) : ""});
  }
  return table;
}

Table gate_rows_table(const ProblemAssessment& assessment) {
  Table table{assessment.definition.name + "-limits",
              "Gate rows",
              "",
              {"verdict", "error measure", "metric", "result"}};
  for (const ProblemGateOutcome& outcome : assessment.gate) {
    table.row_ids.push_back(problem_row_id(assessment.definition.name, table.rows.size()));
    table.rows.push_back({verdict_name(outcome.verdict), outcome.row.measure,
                          metric_name(outcome.row.metric), outcome.message});
    table.reasons.push_back(limit_reason(outcome.row.reason, outcome.row.source));
  }
  return table;
}

// Draws one figure for each kind of step and up to most_curves measures. A measure without an error
// has no curve.
std::vector<reports::Figure> error_figures(const Problem& problem, const ProblemResult& result) {
  std::vector<reports::Figure> figures;
  for (std::size_t m = 0; m < result.outcome.measures.size(); ++m) {
    const MeasuredErrors& measure = result.outcome.measures[m];
    const MeasureKind& kind = problem.measures.at(m);
    if (!kind.has_order) continue;
    reports::Curve curve{.label = measure.name, .style = reports::Curve::Style::line_points};
    for (const auto& [step, error] : measure.errors) {
      curve.x.push_back(step);
      curve.y.push_back(std::abs(error));
    }
    if (std::none_of(curve.y.begin(), curve.y.end(), [](double y) { return y > 0; })) continue;
    const std::string y_label = kind.unit == "1" ? "|error|" : "|error| (" + kind.unit + ")";
    if (figures.empty() || figures.back().x_label != kind.step ||
        figures.back().y_label != y_label || figures.back().curves.size() == most_curves)
      figures.push_back({.id = fmt::format("{}-errors-{}", problem.name, figures.size() + 1),
                         .title = "Errors against resolution",
                         .x_label = kind.step,
                         .y_label = y_label,
                         .log_x = true,
                         .log_y = true});
    figures.back().curves.push_back(std::move(curve));
  }
  return figures;
}

std::string cost_text(const ProblemResult& result) {
  const auto command = result.provenance.find("command");
  return fmt::format("The problem took {:.1f} s of CPU time and {:.0f} MiB.{}",
                     result.cost.core_seconds(), result.cost.peak_memory / 1048576,
                     command == result.provenance.end()
                         ? ""
                         : fmt::format(" Repeat it with `{}`.", command->second));
}

}  // namespace

reports::Section problem_section(const ProblemAssessment& assessment) {
  const Problem& problem = find_problem(assessment.definition.name);
  reports::Section section{
      .id = "problem-" + problem.name,
      .title = problem.title,
      .paragraphs = {problem.statement, "Exact solution: " + problem.exact_solution,
                     "Source: " + problem.source + "."},
      .tables = {gate_rows_table(assessment)},
      .page = problems_page};
  const RunStatus& status = assessment.run.status;
  if (!assessment.run.result) {
    section.paragraphs.push_back(state_name(status.state) + ": " + status.message);
    if (Table failures = failure_table(section.id, {{problem.name, status}});
        !failures.rows.empty())
      section.tables.push_back(std::move(failures));
    return section;
  }
  const ProblemResult& result = *assessment.run.result;
  section.tables.insert(section.tables.begin(), error_table(problem, result));
  section.paragraphs.push_back(cost_text(result));
  std::ranges::copy(result.outcome.tables, std::back_inserter(section.tables));
  section.figures = error_figures(problem, result);
  std::ranges::copy(result.outcome.figures, std::back_inserter(section.figures));
  return section;
}

}  // namespace slosh

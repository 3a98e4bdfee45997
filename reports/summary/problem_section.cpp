#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "reports/figures/figure_panels.hpp"
#include "reports/summary/report_sections.hpp"
#include "reports/tables/case_tables.hpp"
#include "reports/wording/case_text.hpp"
#include "reports/wording/report_places.hpp"
#include "verification/assessment/observed_order.hpp"
#include "verification/case/campaign_definition.hpp"
#include "verification/problems/problem_list.hpp"

namespace slosh {
namespace {

using reports::Table;

std::string order_text(const std::optional<double>& order) {
  return order ? fmt::format("{:.2f}", *order) : "none";
}

std::string error_texts(const std::vector<ErrorAtStep>& errors) {
  std::vector<std::string> texts;
  for (const ErrorAtStep& one : errors) texts.push_back(fmt::format("{:.3g}", one.error));
  return fmt::format("{}", fmt::join(texts, "; "));
}

std::string step_texts(const std::vector<ErrorAtStep>& errors) {
  std::vector<std::string> texts;
  for (const ErrorAtStep& one : errors) texts.push_back(fmt::format("{:.4g}", one.step));
  return fmt::format("{}", fmt::join(texts, "; "));
}

std::string orders_between(const std::vector<ErrorAtStep>& errors) {
  std::vector<std::string> texts;
  for (std::size_t i = 1; i < errors.size(); ++i)
    texts.push_back(order_text(observed_order({errors[i - 1].step, {errors[i - 1].error, 0}},
                                              {errors[i].step, {errors[i].error, 0}})));
  return fmt::format("{}", fmt::join(texts, "; "));
}

Table error_table(const Problem& problem, const ProblemResult& result) {
  Table table{
      problem.name + "-errors",
      "Errors and observed orders",
      "From the coarsest to the finest resolution. Where the steps are resolutions: the orders "
      "between neighbouring ones and the slope of the least-squares line through all.",
      {"error measure", "meaning", "step", "steps", "errors", "unit", "orders", "order"},
      {}};
  for (const MeasuredErrors& measure : result.outcome.measures)
    for (const MeasureKind& kind : problem.measures)
      if (kind.name == measure.name)
        table.rows.push_back({measure.name, kind.meaning, kind.step, step_texts(measure.errors),
                              error_texts(measure.errors), kind.unit,
                              kind.has_order ? orders_between(measure.errors) : "",
                              kind.has_order ? order_text(order_of(measure.errors)) : ""});
  return table;
}

Table gate_rows_table(const ProblemAssessment& assessment) {
  Table table{assessment.definition.name + "-limits",
              "Gate rows",
              "",
              {"verdict", "error measure", "metric", "result"},
              {}};
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
    reports::Curve curve{measure.name, {}, {}, {}, reports::Curve::Style::line_points};
    for (const auto& [step, error] : measure.errors) {
      curve.x.push_back(step);
      curve.y.push_back(std::abs(error));
    }
    if (std::none_of(curve.y.begin(), curve.y.end(), [](double y) { return y > 0; })) continue;
    const std::string y_label = kind.unit == "1" ? "|error|" : "|error| (" + kind.unit + ")";
    if (figures.empty() || figures.back().x_label != kind.step ||
        figures.back().y_label != y_label || figures.back().curves.size() == most_curves) {
      reports::Figure figure;
      figure.id = fmt::format("{}-errors-{}", problem.name, figures.size() + 1);
      figure.title = "Errors against resolution";
      figure.x_label = kind.step;
      figure.y_label = y_label;
      figure.log_x = figure.log_y = true;
      figures.push_back(std::move(figure));
    }
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
  reports::Section section;
  section.id = "problem-" + problem.name;
  section.page = problems_page;
  section.title = problem.title;
  section.paragraphs = {problem.statement, "Exact solution: " + problem.exact_solution,
                        "Source: " + problem.source + "."};
  section.tables = {gate_rows_table(assessment)};
  if (!assessment.run.result) {
    section.paragraphs.push_back(state_name(assessment.run.status.state) + ": " +
                                 assessment.run.status.message);
    if (auto failures = failure_table(section.id, {{problem.name, assessment.run.status}}))
      section.tables.push_back(std::move(*failures));
    return section;
  }
  const ProblemResult& result = *assessment.run.result;
  section.tables.insert(section.tables.begin(), error_table(problem, result));
  section.paragraphs.push_back(cost_text(result));
  for (const reports::Table& one : result.outcome.tables) section.tables.push_back(one);
  section.figures = error_figures(problem, result);
  for (const reports::Figure& one : result.outcome.figures) section.figures.push_back(one);
  return section;
}

}  // namespace slosh

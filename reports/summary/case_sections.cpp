// The sections of one case's page and of its appendix.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "reports/figures/case_figures.hpp"
#include "reports/summary/report_sections.hpp"
#include "reports/tables/case_tables.hpp"
#include "reports/wording/case_text.hpp"
#include "reports/wording/report_places.hpp"
#include "verification/assessment/across_runs/solution_distances.hpp"
#include "verification/assessment/case_assessment.hpp"
#include "verification/assessment/doubts/model_limits.hpp"
#include "verification/assessment/observed_order.hpp"
#include "verification/case/case_definition.hpp"
#include "verification/sensitivity/case_coverage.hpp"
#include "verification/series/interval_text.hpp"

namespace slosh {
namespace {

// What the tables of a case find, in sentences for its summary.

std::optional<std::string> outlier_sentence(const CaseAssessment& assessment) {
  const auto [quantity, runs, distances] = solution_distances(assessment);
  if (runs.size() < 3) return {};
  if (const auto odd = outlier(distances))
    return fmt::format("`{}` stands apart from the other {} solutions in {}.", runs[*odd],
                       runs.size() - 1, quantity);
  return fmt::format("No single one of the {} solutions stands apart from all others in {}.",
                     runs.size(), quantity);
}

// A scheme's first measure is the rms of its residual.
std::vector<std::string> order_sentences(const CaseAssessment& assessment) {
  std::vector<std::string> sentences;
  std::set<std::string> told;
  for (const ErrorFamily& family : error_families(assessment)) {
    if (!told.insert(family.name).second) continue;
    const auto line = least_squares_line(family.errors);
    if (!line) continue;
    const std::string order = slope_text(line->order);
    sentences.push_back(fmt::format("The order of convergence of `{}` over {} resolutions is {}.",
                                    family.name, family.errors.size(), order));
  }
  return sentences;
}

std::optional<std::string> coverage_finding(const CaseCoverage& coverage) {
  if (coverage.rows_judged == 0) return {};
  if (const std::vector<std::string> missed = coverage.missed(); !missed.empty())
    return fmt::format("No gate row detects the required error that is made on purpose in: {}.",
                       fmt::join(missed, ", "));
  return fmt::format(
      "Together the gate rows detect the required errors that are made on purpose: {}.",
      fmt::join(names_of_required(), ", "));
}

// Whether a gate row judges against this reference, or against the impacts that a record publishes.
bool is_judged_against(const CaseDefinition& definition, const std::string& reference) {
  return std::any_of(definition.gate.begin(), definition.gate.end(), [&](const GateRow& row) {
    return row.reference == reference || is_of_impacts(row.metric);
  });
}

// For each record that no row judges against, how far the finest runs are from it.
std::vector<std::string> record_sentences(const CaseAssessment& assessment) {
  std::vector<std::string> sentences;
  for (const RunDefinition& run : assessment.definition.runs) {
    if (!std::holds_alternative<RecordRun>(run.solver) ||
        is_judged_against(assessment.definition, run.name))
      continue;
    std::map<std::string, std::vector<std::string>> told;  // of each quantity
    for (const Comparison& pair : assessment.comparisons)
      if (pair.reference == run.name)
        told[pair.quantity].push_back(
            fmt::format("{:.2g} % (`{}`)", 100 * pair.normalised_rms.value, pair.candidate));
    for (const auto& [quantity, errors] : told)
      sentences.push_back(
          fmt::format("No gate row judges against the record `{}`. In {} the normalised rms "
                      "difference from it is {}.",
                      run.name, quantity, fmt::join(errors, ", ")));
  }
  return sentences;
}

// Says which solution stands apart from the others; how the error of each scheme falls with its
// spacing; how far the runs are from a record that no gate row judges against; and which of the
// errors that are made on purpose no gate row detects. A sentence is left out where the case has
// too few runs for it.
std::vector<std::string> case_findings(const CaseAssessment& assessment,
                                       const CaseCoverage& coverage) {
  std::vector<std::string> findings = order_sentences(assessment);
  if (auto odd = outlier_sentence(assessment)) findings.insert(findings.begin(), std::move(*odd));
  std::ranges::move(record_sentences(assessment), std::back_inserter(findings));
  if (auto detects = coverage_finding(coverage)) findings.push_back(std::move(*detects));
  return findings;
}

using reports::Section;
using reports::Table;

Section section_on(const std::string& page, const std::string& id, const std::string& title) {
  Section section;
  section.id = id;
  section.title = title;
  section.page = page;
  return section;
}

void add(std::optional<Table> table, Section& section) {
  if (table) section.tables.push_back(std::move(*table));
}

Section gate_section(const CaseAssessment& assessment) {
  const CaseDefinition& definition = assessment.definition;
  Section section =
      section_on(page_of_case(definition.name), case_id(definition.name) + "-gate", "Gate");
  if (definition.gate.empty())
    section.paragraphs.push_back("No gate row judges this case.");
  else
    section.tables = gate_tables(assessment);
  add(remedy_table(assessment), section);
  add(failure_table(definition.name, assessment.runs.status), section);
  return section;
}

std::string tank_sentence(const TankDefinition& tank) {
  if (!tank.outline.empty()) return "The tank is " + tank_text(tank);
  return fmt::format("Tank {} m x {} m", tank.length, tank.height);
}

std::string case_paragraph(const CaseDefinition& definition) {
  return fmt::format(
      "{}. {}, liquid {}; {}; {} s from rest in the {}-fixed frame. The comparison "
      "window is from {} to {} s.",
      definition.source, tank_sentence(definition.tank), liquid_text(definition),
      motion_text(definition), definition.duration,
      definition.start == Start::earth ? "earth" : "tank", definition.window_begin,
      definition.window_end);
}

Section results_section(const CaseAssessment& assessment) {
  const CaseDefinition& definition = assessment.definition;
  Section section =
      section_on(page_of_case(definition.name), case_id(definition.name), "Case and runs");
  section.paragraphs = {case_paragraph(definition)};
  for (const auto& [run, status] : assessment.runs.status)
    if (status.state == RunState::out_of_range)
      section.paragraphs.push_back("The reference `" + run + "` " + status.message +
                                   ": it is shown, but never gates.");
    else if (status.state == RunState::not_supplied)
      section.paragraphs.push_back("The record `" + run + "` is not supplied: " + status.message +
                                   (is_judged_against(definition, run)
                                        ? ". Rows that need it neither pass nor fail."
                                        : ". No gate row needs it."));
  for (const ModelLimit& limit : model_limits(definition, assessment.runs))
    if (limit.exceeded())
      section.paragraphs.push_back(
          "This effect is beyond the limit of the models: " + limit_text(limit) + ".");
  for (const std::string& pair : assessment.not_comparable)
    section.paragraphs.push_back("Not comparable: " + pair + ".");
  section.figures = case_figures(assessment);
  section.fields = case_fields(assessment);
  add(field_table(assessment), section);
  return section;
}

Section tables_section(const CaseAssessment& assessment,
                       const std::vector<RowSensitivity>& sensitivity,
                       const CaseCoverage& coverage) {
  const CaseDefinition& definition = assessment.definition;
  Section section =
      section_on(appendix_of_case(definition.name), case_id(definition.name) + "-tables", "Tables");
  add(uncertainty_table(assessment), section);
  if (!definition.gate.empty())
    section.tables.push_back(sensitivity_table(assessment, sensitivity));
  section.tables.push_back(coverage_table(case_id(definition.name) + "-coverage", {coverage}));
  add(distance_table(assessment), section);
  add(refinement_table(assessment), section);
  add(rest_table(assessment), section);
  add(impact_table(assessment), section);
  add(ensemble_table(assessment), section);
  add(repeat_table(assessment), section);
  add(ablation_table(assessment), section);
  add(order_table(assessment), section);
  if (!assessment.comparisons.empty()) {
    if (!fitted_modes(definition).empty()) section.tables.push_back(mode_table(assessment));
    section.tables.push_back(history_table(assessment));
  }
  for (Table& table : work_precision_tables(assessment)) section.tables.push_back(std::move(table));
  section.tables.push_back(cost_table(assessment));
  if (auto steps = step_table(assessment)) section.tables.push_back(std::move(*steps));
  section.tables.push_back(terms_table(assessment));
  section.tables.push_back(provenance_table(assessment));
  return section;
}

}  // namespace

std::vector<Section> case_sections(const CaseAssessment& assessment,
                                   const std::vector<RowSensitivity>& sensitivity,
                                   const CaseCoverage& coverage) {
  const std::string& name = assessment.definition.name;
  std::vector<Section> sections;
  Section summary = section_on(page_of_case(name), case_id(name) + "-summary", "Summary");
  summary.paragraphs = case_findings(assessment, coverage);
  summary.figures = {tank_figure(assessment.definition)};
  sections.push_back(std::move(summary));
  sections.push_back(gate_section(assessment));
  sections.push_back(results_section(assessment));
  Section further =
      section_on(appendix_of_case(name), case_id(name) + "-figures", "Further figures");
  further.figures = appendix_figures(assessment);
  if (!further.figures.empty()) sections.push_back(std::move(further));
  sections.push_back(tables_section(assessment, sensitivity, coverage));
  return sections;
}

}  // namespace slosh

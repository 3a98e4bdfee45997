// The sections of one case's page and of its appendix.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <set>

#include "reports/figures/case_figures.hpp"
#include "reports/summary/report_sections.hpp"
#include "reports/tables/case_tables.hpp"
#include "reports/wording/case_text.hpp"
#include "verification/assessment/across_runs/solution_distances.hpp"
#include "verification/assessment/doubts/model_limits.hpp"
#include "verification/assessment/observed_order.hpp"
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

// A sentence is left out where the case has too few runs for it.
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

std::string detection_text(const RowSensitivity& row, Spoiling spoiling) {
  if (!row.passes_as_it_is) return "does not pass as it is";
  const auto found = row.detects.find(spoiling);
  if (found == row.detects.end()) return "not applicable";
  return found->second ? "detected" : "not detected";
}

Section section_on(const std::string& page, const CaseDefinition& definition, const std::string& id,
                   const std::string& title) {
  return {.id = case_id(definition.name) + id, .title = title, .page = page};
}

void add(Table table, Section& section) {
  if (!table.rows.empty()) section.tables.push_back(std::move(table));
}

Section gate_section(const CaseAssessment& assessment) {
  const CaseDefinition& definition = assessment.definition;
  Section section = section_on(case_id(definition.name), definition, "-gate", "Gate");
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
  Section section = section_on(case_id(definition.name), definition, "", "Case and runs");
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
  Section section = section_on(appendix_of_case(definition.name), definition, "-tables", "Tables");
  add(uncertainty_table(assessment), section);
  add(sensitivity_table(assessment, sensitivity), section);
  add(coverage_table(case_id(definition.name) + "-coverage", {coverage}), section);
  for (const auto& make :
       {distance_table, refinement_table, rest_table, impact_table, ensemble_table, repeat_table,
        ablation_table, order_table, mode_table, history_table})
    add(make(assessment), section);
  for (Table& table : work_precision_tables(assessment)) add(std::move(table), section);
  for (const auto& make : {cost_table, step_table, terms_table, provenance_table})
    add(make(assessment), section);
  return section;
}

}  // namespace

Table sensitivity_table(const CaseAssessment& assessment,
                        const std::vector<RowSensitivity>& sensitivity) {
  Table table = case_table(
      assessment.definition, "strength", "What each gate row detects",
      "The row judges its candidate spoiled on purpose: values times 1.1, ten degrees late, off by "
      "2 % of the fill depth (a pressure: of that under it), with white noise of 10 % of the "
      "standard deviation, cut short by a fifth of the window, with one sample NaN.",
      {"row"});
  for (const Spoiling spoiling : all_spoilings) table.header.push_back(spoiling_name(spoiling));
  for (const RowSensitivity& one : sensitivity) {
    table.rows.push_back({short_row_name(one.row)});
    for (const Spoiling spoiling : all_spoilings)
      table.rows.back().push_back(detection_text(one, spoiling));
  }
  return table;
}

Table coverage_table(const std::string& id, const std::vector<CaseCoverage>& cases) {
  Table table{id,
              "What the rows of each case detect together",
              "Detected: at least one row of the case that passes as it is does not pass with its "
              "candidate spoiled. Not applicable: nothing moves the liquid.",
              {"case", "rows judged", "rows declared"}};
  append(table.header, names_of_required());
  for (const CaseCoverage& one : cases) {
    table.rows.push_back(
        {one.case_name, std::to_string(one.rows_judged), std::to_string(one.rows_declared)});
    for (const RequiredDetection& required : required_detections)
      table.rows.back().push_back(coverage_name(one.detections.at(required.spoiling).coverage));
  }
  return table;
}

std::vector<Section> case_sections(const CaseAssessment& assessment,
                                   const std::vector<RowSensitivity>& sensitivity,
                                   const CaseCoverage& coverage) {
  const CaseDefinition& definition = assessment.definition;
  Section summary = section_on(case_id(definition.name), definition, "-summary", "Summary");
  summary.paragraphs = case_findings(assessment, coverage);
  summary.figures = {tank_figure(definition)};
  std::vector<Section> sections{std::move(summary), gate_section(assessment),
                                results_section(assessment)};
  Section further =
      section_on(appendix_of_case(definition.name), definition, "-figures", "Further figures");
  further.figures = appendix_figures(assessment);
  if (!further.figures.empty()) sections.push_back(std::move(further));
  sections.push_back(tables_section(assessment, sensitivity, coverage));
  return sections;
}

}  // namespace slosh

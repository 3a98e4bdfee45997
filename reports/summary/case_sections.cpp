// The sections of one case's page and of its appendix.
#include <fmt/format.h>

#include <utility>

#include "reports/figures/case_figures.hpp"
#include "reports/summary/case_findings.hpp"
#include "reports/summary/report_sections.hpp"
#include "reports/summary/sensitivity_tables.hpp"
#include "reports/tables/case_tables.hpp"
#include "reports/wording/case_text.hpp"
#include "reports/wording/report_places.hpp"
#include "verification/assessment/doubts/model_limits.hpp"
#include "verification/case/case_definition.hpp"

namespace slosh {
namespace {

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
    section.tables = {gate_table(assessment)};
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
  if (!summary.paragraphs.empty()) sections.push_back(std::move(summary));
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

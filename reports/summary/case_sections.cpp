// The sections of one case's page.
#include <fmt/format.h>

#include <utility>

#include "reports/figures/case_figures.hpp"
#include "reports/summary/report_sections.hpp"
#include "reports/summary/sensitivity_tables.hpp"
#include "reports/tables/case_tables.hpp"
#include "reports/wording/case_text.hpp"
#include "reports/wording/report_places.hpp"
#include "verification/case/case_definition.hpp"

namespace slosh {
namespace {
using reports::Section;
}

Section gate_section(const CaseAssessment& assessment) {
  const CaseDefinition& definition = assessment.definition;
  Section section;
  section.id = definition.name + "-gate";
  section.title = "Gate";
  section.page = page_of_case(definition.name);
  if (definition.gate.empty())
    section.paragraphs.push_back("No gate row judges this case.");
  else
    section.tables = {gate_table(assessment), limits_table(assessment)};
  if (auto failures = failure_table(definition.name, assessment.runs.status))
    section.tables.push_back(std::move(*failures));
  return section;
}

Section case_section(const CaseAssessment& assessment,
                     const std::vector<RowSensitivity>& sensitivity) {
  const CaseDefinition& definition = assessment.definition;
  Section section;
  section.id = definition.name;
  section.title = "Case and runs";
  section.page = page_of_case(definition.name);
  section.paragraphs = {
      fmt::format("{}. Tank {} m x {} m, liquid {}; {}; {} s from rest in the {}-fixed frame. "
                  "The comparison window is from {} to {} s.",
                  definition.source, definition.tank.length, definition.tank.height,
                  liquid_text(definition), motion_text(definition), definition.duration,
                  definition.start == Start::earth ? "earth" : "tank", definition.window_begin,
                  definition.window_end)};
  for (const auto& [run, status] : assessment.runs.status)
    if (status.state == RunState::out_of_range)
      section.paragraphs.push_back("The reference `" + run + "` " + status.message +
                                   ": it is shown, but never gates.");
    else if (status.state == RunState::not_supplied)
      section.paragraphs.push_back("The record `" + run + "` is not supplied: " + status.message +
                                   ". Rows that need it neither pass nor fail.");
  for (const std::string& pair : assessment.not_comparable)
    section.paragraphs.push_back("Not comparable: " + pair + ".");
  section.figures = case_figures(assessment);
  section.fields = case_fields(assessment);
  if (auto uncertain = uncertainty_table(assessment))
    section.tables.push_back(std::move(*uncertain));
  if (!definition.gate.empty())
    section.tables.push_back(sensitivity_table(assessment, sensitivity));
  section.tables.push_back(
      coverage_table(definition.name + "-coverage", {case_coverage(assessment, sensitivity)}));
  if (auto remedies = remedy_table(assessment)) section.tables.push_back(std::move(*remedies));
  if (auto matrix = distance_table(assessment)) section.tables.push_back(std::move(*matrix));
  if (auto refined = refinement_table(assessment)) section.tables.push_back(std::move(*refined));
  if (auto rest = rest_table(assessment)) section.tables.push_back(std::move(*rest));
  if (auto impacts = impact_table(assessment)) section.tables.push_back(std::move(*impacts));
  if (auto ensembles = ensemble_table(assessment)) section.tables.push_back(std::move(*ensembles));
  if (auto repeats = repeat_table(assessment)) section.tables.push_back(std::move(*repeats));
  if (auto choices = ablation_table(assessment)) section.tables.push_back(std::move(*choices));
  if (auto orders = order_table(assessment)) section.tables.push_back(std::move(*orders));
  if (!assessment.comparisons.empty()) {
    if (!fitted_modes(definition).empty()) section.tables.push_back(mode_table(assessment));
    section.tables.push_back(history_table(assessment));
  }
  for (reports::Table& table : work_precision_tables(assessment))
    section.tables.push_back(std::move(table));
  section.tables.push_back(cost_table(assessment));
  section.tables.push_back(terms_table(assessment));
  section.tables.push_back(provenance_table(assessment));
  return section;
}

}  // namespace slosh

// The tables of pressure fields that were compared with interFoam's.
#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "reports/tables/case_tables.hpp"
#include "reports/wording/report_places.hpp"
#include "verification/gate/field_metrics.hpp"

namespace slosh {
namespace {

using reports::Table;
using Row = std::vector<std::string>;

double mean_of(const FieldComparison& compared, double FieldDifference::*value) {
  double sum = 0;
  for (const FieldDifference& moment : compared.moments) sum += moment.*value;
  return sum / static_cast<double>(compared.moments.size());
}

double lowest_of(const FieldComparison& compared, double FieldDifference::*value) {
  double lowest = compared.moments.front().*value;
  for (const FieldDifference& moment : compared.moments) lowest = std::min(lowest, moment.*value);
  return lowest;
}

std::string fields_caption(const CaseDefinition& definition) {
  return fmt::format(
      "The pressure of each run less interFoam's, on interFoam's cells that are at least half "
      "liquid and that the run's liquid covers by half or more: the rms over these cells in "
      "percent of the pressure under the fill depth, {:.4g} Pa. Tension: the share of these cells "
      "with a pressure below -{:.3g} Pa, the mean over the moments; in brackets interFoam's. "
      "Lowest: the lowest of these cells at any of the moments. Not covered: interFoam's liquid "
      "cells that the run does not cover. Excess: the cells that it covers where interFoam has no "
      "liquid. Both are over interFoam's liquid cells, the mean over the moments.",
      pressure_under_depth(definition), small_tension_share * pressure_under_depth(definition));
}

Row field_row(const FieldComparison& compared, const CaseDefinition& definition) {
  const double scale = 100 / pressure_under_depth(definition);
  Row row{compared.candidate, compared.reference};
  for (const FieldDifference& moment : compared.moments)
    row.push_back(fmt::format("{:.1f}", scale * moment.pressure_rms));
  row.push_back(fmt::format("{:.1f}", scale * mean_of(compared, &FieldDifference::pressure_rms)));
  row.push_back(fmt::format("{:.2f} ({:.2f})",
                            100 * mean_of(compared, &FieldDifference::tension_share),
                            100 * mean_of(compared, &FieldDifference::reference_tension_share)));
  row.push_back(fmt::format("{:.0f} ({:.0f})",
                            lowest_of(compared, &FieldDifference::lowest_pressure),
                            lowest_of(compared, &FieldDifference::reference_lowest_pressure)));
  row.push_back(fmt::format("{:.1f}", 100 * mean_of(compared, &FieldDifference::uncovered_share)));
  row.push_back(fmt::format("{:.1f}", 100 * mean_of(compared, &FieldDifference::excess_share)));
  return row;
}

}  // namespace

std::optional<Table> field_table(const CaseAssessment& assessment) {
  const CaseDefinition& definition = assessment.definition;
  if (assessment.fields.empty()) return std::nullopt;
  Table table{case_id(definition.name) + "-pressure-fields",
              "Pressure fields against interFoam's",
              fields_caption(definition),
              {"run", "against"},
              {}};
  for (const FieldDifference& moment : assessment.fields.front().moments)
    table.header.push_back(fmt::format("rms at {:.4g} s [%]", moment.time));
  table.header.insert(table.header.end(), {"mean rms [%]", "tension [%]", "lowest [Pa]",
                                           "not covered [%]", "excess [%]"});
  for (const FieldComparison& compared : assessment.fields)
    table.rows.push_back(field_row(compared, definition));
  return table;
}

}  // namespace slosh

#include "reports/summary/report_sections.hpp"

#include "reports/wording/report_places.hpp"

namespace slosh {
namespace {

std::string detection_text(const RowSensitivity& row, Spoiling spoiling) {
  if (!row.passes_as_it_is) return "does not pass as it is";
  const auto found = row.detects.find(spoiling);
  if (found == row.detects.end()) return "not applicable";
  return found->second ? "detected" : "not detected";
}

}  // namespace

reports::Table sensitivity_table(const CaseAssessment& assessment,
                                 const std::vector<RowSensitivity>& sensitivity) {
  reports::Table table{
      case_id(assessment.definition.name) + "-strength",
      "What each gate row detects",
      "The row judges its candidate spoiled on purpose: values times 1.1, ten degrees late, off by "
      "2 % of the fill depth (a pressure: of that under it), with white noise of 10 % of the "
      "standard deviation, cut short by a fifth of the window, with one sample NaN.",
      {"row"},
      {}};
  for (const Spoiling spoiling : all_spoilings) table.header.push_back(spoiling_name(spoiling));
  for (const RowSensitivity& one : sensitivity) {
    std::vector<std::string> line{short_row_name(one.row)};
    for (const Spoiling spoiling : all_spoilings) line.push_back(detection_text(one, spoiling));
    table.rows.push_back(std::move(line));
  }
  return table;
}

reports::Table coverage_table(const std::string& id, const std::vector<CaseCoverage>& cases) {
  reports::Table table{id,
                       "What the rows of each case detect together",
                       "Detected: at least one row of the case that passes as it is does not pass "
                       "with its candidate "
                       "spoiled. Not applicable: nothing moves the liquid.",
                       {"case", "rows judged", "rows declared"},
                       {}};
  for (const std::string& name : names_of_required()) table.header.push_back(name);
  for (const CaseCoverage& one : cases) {
    std::vector<std::string> line{one.case_name, std::to_string(one.rows_judged),
                                  std::to_string(one.rows_declared)};
    for (const RequiredDetection& required : required_detections)
      line.push_back(coverage_name(one.detections.at(required.spoiling).coverage));
    table.rows.push_back(std::move(line));
  }
  return table;
}

}  // namespace slosh

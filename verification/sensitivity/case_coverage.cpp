#include "verification/sensitivity/case_coverage.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

#include "verification/files/content_hash.hpp"

namespace slosh {
namespace {

int judged_rows(const CaseAssessment& assessment) {
  return static_cast<int>(
      std::count_if(assessment.gate.begin(), assessment.gate.end(),
                    [](const GateOutcome& outcome) { return is_judged(outcome.verdict); }));
}

CaseCoverage::Detection detection_of(const RequiredDetection& required,
                                     const CaseDefinition& definition,
                                     const std::vector<RowStrength>& strengths) {
  CaseCoverage::Detection found{Coverage::detected, {}};
  for (const auto& [row, strength] : strengths)
    if (detects(strength, {required.kind, required.strength})) found.rows.push_back(row_name(row));
  if (found.rows.empty())
    found.coverage =
        required.of_motion && !is_moved(definition) ? Coverage::not_applicable : Coverage::missed;
  return found;
}

}  // namespace

bool CaseCoverage::is_complete() const {
  return std::none_of(detections.begin(), detections.end(),
                      [](const auto& one) { return one.second.coverage == Coverage::missed; });
}

bool is_moved(const CaseDefinition& definition) {
  return !definition.motion.still() || definition.initial_wave || definition.liquid.column_width;
}

std::string bound_text(const GateRow& row) {
  std::string text = fmt::format("{}\n{}\n", row_name(row), row.unit);
  if (row.limit) text += fmt::format("limit {}\n", *row.limit);
  if (row.between) text += fmt::format("between {} {}\n", row.between->first, row.between->second);
  if (row.error) text += fmt::format("error {}\n", *row.error);
  return text;
}

std::string hash_of_rows(const CaseDefinition& definition) {
  std::string text;
  for (const GateRow& row : definition.gate) text += bound_text(row);
  return content_hash(text);
}

CaseCoverage case_coverage(const CaseAssessment& assessment,
                           const std::vector<RowStrength>& strengths) {
  const CaseDefinition& definition = assessment.definition;
  CaseCoverage coverage{definition.name,
                        hash_of_rows(definition),
                        static_cast<int>(definition.gate.size()),
                        judged_rows(assessment),
                        {}};
  for (const RequiredDetection& required : required_detections)
    coverage.detections[required.name] = detection_of(required, definition, strengths);
  return coverage;
}

std::string coverage_name(Coverage coverage) {
  switch (coverage) {
    case Coverage::detected:
      return "detected";
    case Coverage::missed:
      return "MISSED";
    case Coverage::not_applicable:
      return "not applicable";
  }
  throw std::logic_error("a coverage without a name");
}

reports::Table coverage_table(const std::string& id, const std::vector<CaseCoverage>& cases) {
  reports::Table table{
      id,
      "What the rows of each case detect together",
      "Each candidate made wrong on purpose: values times 1.1, ten degrees late, off by 2 % of the "
      "fill depth (a pressure: of that under it), with white noise of 10 % of the standard "
      "deviation, cut short by a fifth of the window. Detected: at least one row of the case that "
      "passes as it is does not pass any more. Not applicable: nothing moves the liquid.",
      {"case", "rows judged", "rows declared"},
      {}};
  for (const RequiredDetection& one : required_detections) table.header.emplace_back(one.name);
  for (const CaseCoverage& one : cases) {
    std::vector<std::string> line{one.case_name, std::to_string(one.rows_judged),
                                  std::to_string(one.rows_declared)};
    for (const RequiredDetection& required : required_detections)
      line.push_back(coverage_name(one.detections.at(required.name).coverage));
    table.rows.push_back(std::move(line));
  }
  return table;
}

std::string coverage_sentence(const std::vector<CaseAssessment>& cases) {
  int judged = 0, declared = 0;
  std::vector<std::string> unjudged;
  for (const CaseAssessment& one : cases) {
    if (!has_selected_runs(one)) continue;
    const int of_case = judged_rows(one);
    judged += of_case;
    declared += static_cast<int>(one.gate.size());
    if (of_case == 0) unjudged.push_back(one.definition.name);
  }
  if (judged == declared && unjudged.empty()) return "";
  std::string text = fmt::format(" {} of {} rows declared are judged", judged, declared);
  if (!unjudged.empty()) text += fmt::format("; no row judges {}", fmt::join(unjudged, ", "));
  return text + ".";
}

}  // namespace slosh

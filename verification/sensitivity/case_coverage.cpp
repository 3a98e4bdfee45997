#include "verification/sensitivity/case_coverage.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "verification/files/atomic_file.hpp"
#include "verification/files/content_hash.hpp"
#include "verification/files/foreign/json_text.hpp"

namespace slosh {
namespace {

int judged_rows(const CaseAssessment& assessment) {
  return static_cast<int>(
      std::count_if(assessment.gate.begin(), assessment.gate.end(),
                    [](const GateOutcome& outcome) { return is_judged(outcome.verdict); }));
}

// Whether anything moves the liquid: the tank's motion, an initial wave, a breaking dam.
bool is_moved(const CaseDefinition& definition) {
  return !definition.motion.still() || definition.initial_wave || definition.liquid.column_width;
}

CaseCoverage::Detection detection_of(const RequiredDetection& required,
                                     const CaseDefinition& definition,
                                     const std::vector<RowSensitivity>& sensitivity) {
  CaseCoverage::Detection found{Coverage::detected, {}};
  for (const auto& [row, passes, detects] : sensitivity)
    if (const auto one = detects.find(required.spoiling); one != detects.end() && one->second)
      found.rows.push_back(row_name(row));
  if (found.rows.empty())
    found.coverage =
        required.of_motion && !is_moved(definition) ? Coverage::not_applicable : Coverage::missed;
  return found;
}

// What a row judges, as text: its name, unit and bounds.
std::string row_identity(const GateRow& row) {
  std::string text = fmt::format("{}\n{}\n", row_name(row), row.unit);
  if (row.limit) text += fmt::format("limit {}\n", *row.limit);
  if (row.between) text += fmt::format("between {} {}\n", row.between->first, row.between->second);
  if (row.error) text += fmt::format("error {}\n", *row.error);
  return text;
}

}  // namespace

std::vector<std::string> names_of_required() {
  std::vector<std::string> names;
  for (const RequiredDetection& one : required_detections)
    names.push_back(spoiling_name(one.spoiling));
  return names;
}

std::vector<std::string> CaseCoverage::missed() const {
  std::vector<std::string> names;
  for (const auto& [spoiling, detection] : detections)
    if (detection.coverage == Coverage::missed) names.push_back(spoiling_name(spoiling));
  return names;
}

std::string hash_of_rows(const CaseDefinition& definition) {
  std::vector<std::string> rows;
  for (const GateRow& row : definition.gate) rows.push_back(row_identity(row));
  std::sort(rows.begin(), rows.end());
  std::string text;
  for (const std::string& row : rows) text += row;
  return content_hash(text);
}

CaseCoverage case_coverage(const CaseAssessment& assessment,
                           const std::vector<RowSensitivity>& sensitivity) {
  const CaseDefinition& definition = assessment.definition;
  CaseCoverage coverage{definition.name,
                        hash_of_rows(definition),
                        static_cast<int>(definition.gate.size()),
                        judged_rows(assessment),
                        {}};
  for (const RequiredDetection& required : required_detections)
    coverage.detections[required.spoiling] = detection_of(required, definition, sensitivity);
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

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

Json json_of(const CaseCoverage& one) {
  Json detections = Json::object();
  for (const RequiredDetection& required : required_detections) {
    const CaseCoverage::Detection& detection = one.detections.at(required.spoiling);
    detections[spoiling_name(required.spoiling)] = {{"coverage", coverage_name(detection.coverage)},
                                                    {"rows", detection.rows}};
  }
  return {{"case", one.case_name},
          {"rows", one.rows_hash},
          {"rows_declared", one.rows_declared},
          {"rows_judged", one.rows_judged},
          {"detections", detections}};
}

Coverage coverage_from(const std::string& name) {
  for (const Coverage one : {Coverage::detected, Coverage::missed, Coverage::not_applicable})
    if (coverage_name(one) == name) return one;
  throw SelftestRecordError("no coverage: " + name);
}

CaseCoverage coverage_from(const Json& one) {
  CaseCoverage coverage{
      one.at("case"), one.at("rows"), one.at("rows_declared"), one.at("rows_judged"), {}};
  for (const RequiredDetection& required : required_detections) {
    const Json& detection = one.at("detections").at(spoiling_name(required.spoiling));
    coverage.detections[required.spoiling] = {
        coverage_from(detection.at("coverage").get<std::string>()), detection.at("rows")};
  }
  return coverage;
}

}  // namespace

fs::path selftest_record_file(const fs::path& baselines, const std::string& campaign, bool quick) {
  return baselines / (campaign + (quick ? "-quick" : "") + ".selftest.json");
}

void write_selftest_record(const SelftestRecord& record, const fs::path& file) {
  if (fs::exists(file)) read_selftest_record(file);  // nothing else is replaced
  Json cases = Json::array();
  for (const CaseCoverage& one : record.cases) cases.push_back(json_of(one));
  const Json content{{"campaign", record.campaign}, {"quick", record.quick}, {"cases", cases}};
  replace_file(file, content.dump(2) + "\n", Durability::process_crash);
}

SelftestRecord read_selftest_record(const fs::path& file) {
  if (!fs::exists(file))
    throw SelftestRecordError(file.string() +
                              ": the file is missing; `slosh gate --selftest --record` writes it");
  try {
    const Json content = parsed_json<Json>(read_bytes(file));
    SelftestRecord record{content.at("campaign"), content.at("quick"), {}};
    for (const Json& one : content.at("cases")) record.cases.push_back(coverage_from(one));
    return record;
  } catch (const Json::exception& error) {
    throw SelftestRecordError(file.string() + ": not a record of a self-test: " + words_of(error));
  }
}

std::vector<std::string> shortcomings(const SelftestRecord& record,
                                      const std::vector<CaseDefinition>& cases) {
  std::vector<std::string> found;
  for (const CaseDefinition& definition : cases) {
    const auto one = std::find_if(
        record.cases.begin(), record.cases.end(),
        [&](const CaseCoverage& coverage) { return coverage.case_name == definition.name; });
    if (one == record.cases.end()) {
      found.push_back(definition.name + ": is not in the record");
      continue;
    }
    if (one->rows_hash != hash_of_rows(definition))
      found.push_back(definition.name + ": its rows have changed since the record was made");
    for (const std::string& name : one->missed())
      found.push_back(fmt::format("{}: no row detects the {}", definition.name, name));
  }
  return found;
}

}  // namespace slosh

#include "verification/sensitivity/selftest_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "verification/files/atomic_file.hpp"
#include "verification/files/content_hash.hpp"
#include "verification/files/foreign/json_text.hpp"

namespace slosh {
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

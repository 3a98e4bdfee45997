// The record of a shipped campaign's self-test, kept in the repository beside the baselines, so
// that a test can check every shipped case against it without running the campaigns:
//   <baselines>/NAME.selftest.json, NAME-quick.selftest.json:
//   {"campaign", "quick", "cases": [{"case", "rows", "rows_declared", "rows_judged",
//     "detections": {"amplitude": {"coverage": "detected", "rows": [...]}, ...}}]}
// `rows` is the hash of the case's rows (case_coverage.hpp): the record is out of date where a row
// has changed since.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "verification/sensitivity/case_coverage.hpp"

namespace slosh {

struct SelftestRecord {
  std::string campaign;
  bool quick;
  std::vector<CaseCoverage> cases;
};

// The record is missing or cannot be read; what() names the file.
struct SelftestRecordError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

std::filesystem::path selftest_record_file(const std::filesystem::path& baselines,
                                           const std::string& campaign, bool quick);

// Throws std::filesystem::filesystem_error.
void write_selftest_record(const SelftestRecord& record, const std::filesystem::path& file);

// Throws SelftestRecordError.
SelftestRecord read_selftest_record(const std::filesystem::path& file);

// The reasons why the record does not hold for these cases, one line each: a case that it lacks,
// rows that have changed since, a detection that is missed.
std::vector<std::string> shortcomings(const SelftestRecord& record,
                                      const std::vector<CaseDefinition>& cases);

}  // namespace slosh

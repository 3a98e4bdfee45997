// What the self-test of a shipped campaign found, kept in the repository beside the baselines, so
// that a test holds every shipped case to it without running the campaigns:
//   <baselines>/NAME.selftest.json, NAME-quick.selftest.json:
//   {"campaign", "quick", "cases": [{"case", "rows", "rows_declared", "rows_judged",
//     "detections": {"amplitude": {"coverage": "detected", "rows": [...]}, ...}}]}
// `rows` is the hash of the case's rows (case_coverage.hpp): a row that has changed since makes the
// record one of other rows.
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

// A record that is not there or cannot be read. what() says the file.
struct SelftestRecordError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

std::filesystem::path selftest_record_file(const std::filesystem::path& baselines,
                                           const std::string& campaign, bool quick);

// Throws std::filesystem::filesystem_error.
void write_selftest_record(const SelftestRecord& record, const std::filesystem::path& file);

// Throws SelftestRecordError.
SelftestRecord read_selftest_record(const std::filesystem::path& file);

// What keeps the record from holding for these cases, one line each: a case that it does not have,
// rows that have changed since, a detection that is missed.
std::vector<std::string> shortcomings(const SelftestRecord& record,
                                      const std::vector<CaseDefinition>& cases);

}  // namespace slosh

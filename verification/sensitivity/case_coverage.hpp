// The spoilings that the gate rows of a case detect together, found on the
// case's own results. The rows of every case must detect the amplitude, the lag, the datum, noise
// and truncation, each by at least one row that passes as it is. Where nothing moves the liquid,
// its amplitude, lag and noise are not applicable unless a row detects them.
//
// The record of a shipped campaign's self-test, kept in the repository beside the baselines, so
// that a test can check every shipped case against it without running the campaigns:
//   <baselines>/NAME.selftest.json, NAME-quick.selftest.json:
//   {"campaign", "quick", "cases": [{"case", "rows", "rows_declared", "rows_judged",
//     "detections": {"amplitude": {"coverage": "detected", "rows": [...]}, ...}}]}
// `rows` is the hash of the case's rows: the record is out of date where a row has changed since.
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "verification/sensitivity/gate_sensitivity.hpp"

namespace slosh {

struct RequiredDetection {
  Spoiling spoiling;
  bool of_motion;  // not applicable where nothing moves the liquid
};

inline constexpr std::array<RequiredDetection, 5> required_detections{
    {{Spoiling::amplitude, true},
     {Spoiling::lag, true},
     {Spoiling::datum, false},
     {Spoiling::noise, true},
     {Spoiling::truncation, false}}};

std::vector<std::string> names_of_required();  // "amplitude", ...

enum class Coverage { detected, missed, not_applicable };

struct CaseCoverage {
  std::string case_name;
  std::string rows_hash;  // hash_of_rows()
  int rows_declared, rows_judged;
  struct Detection {
    Coverage coverage;
    std::vector<std::string> rows;  // those that detect it
  };
  std::map<Spoiling, Detection> detections;  // of required_detections

  std::vector<std::string> missed() const;  // the names of spoilings
};

// The hash of the declared rows, in whatever order: candidate, reference, quantity, metric and
// bounds.
std::string hash_of_rows(const CaseDefinition& definition);

std::string coverage_name(Coverage coverage);  // "detected", "MISSED", "not applicable"

CaseCoverage case_coverage(const CaseAssessment& assessment,
                           const std::vector<RowSensitivity>& sensitivity);

// " 22 of 26 rows declared are judged; no row judges A, B." Returns "" where all rows are judged
// and each case has one. A case is left out where none of its runs is selected.
std::string coverage_sentence(const std::vector<CaseAssessment>& cases);

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

// The mutations that the gate rows of a case detect together, found on the case's own results. The
// rows of every case must detect each of the following, by at least one row that passes as it is:
//   amplitude   values times 1.1
//   lag         ten degrees of the judged mode's period
//   datum       an offset of 2 % of the fill depth, or of the pressure under it
//   noise       white, 10 % of the values' standard deviation
//   truncation  a series that ends a fifth of the window early
// Where nothing moves the liquid, its amplitude, lag and noise are not applicable unless a row
// detects them. Rows that do not pass as they are detect nothing.
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "verification/sensitivity/gate_sensitivity.hpp"

namespace slosh {

struct RequiredDetection {
  const char* name;
  MutationKind kind;
  double strength;
  bool of_motion;  // not applicable where nothing moves the liquid
};

inline constexpr std::array<RequiredDetection, 5> required_detections{
    {{"amplitude", MutationKind::louder, 0.1, true},
     {"lag", MutationKind::late, ten_degrees, true},
     {"datum", MutationKind::raised, 0.02, false},
     {"noise", MutationKind::noisy, 0.1, true},
     {"truncation", MutationKind::truncated, 0.2, false}}};

enum class Coverage { detected, missed, not_applicable };

struct CaseCoverage {
  std::string case_name;
  std::string rows_hash;  // hash_of_rows()
  int rows_declared, rows_judged;
  struct Detection {
    Coverage coverage;
    std::vector<std::string> rows;  // those that detect it
  };
  std::map<std::string, Detection> detections;  // by required_detections' names

  bool is_complete() const;  // nothing is missed
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

}  // namespace slosh

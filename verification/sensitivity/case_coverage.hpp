// What the gate rows of a case detect together, found out on the case's own results. Every case
// must detect, by one row or another that passes as it is, each of
//   amplitude   values times 1.1
//   lag         ten degrees of the judged mode's period
//   datum       an offset of 2 % of the fill depth, of a pressure 2 % of that under it
//   noise       white, 10 % of the values' standard deviation
//   truncation  a series that ends a fifth of the window early
// Of liquid that nothing moves there is no amplitude, lag or deviation to speak of: what its rows
// do not detect of these is not applicable. Rows that do not pass as they are detect nothing.
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "reports/model/report_model.hpp"
#include "verification/sensitivity/row_strength.hpp"

namespace slosh {

struct RequiredDetection {
  const char* name;
  MutationKind kind;
  double strength;
  bool of_motion;  // means nothing where nothing moves
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
  std::string rows_hash;  // of all that decides what the case's rows judge
  int rows_declared, rows_judged;
  struct Detection {
    Coverage coverage;
    std::vector<std::string> rows;  // that detect it
  };
  std::map<std::string, Detection> detections;  // by required_detections' names

  bool is_complete() const;  // nothing is missed
};

// Whether anything moves the liquid: the tank's motion, a wave, a dam that breaks.
bool is_moved(const CaseDefinition& definition);

// What a row judges: its name, unit and bounds.
std::string bound_text(const GateRow& row);

// Of the rows as the case declares them: candidate, reference, quantity, metric and bounds.
std::string hash_of_rows(const CaseDefinition& definition);

std::string coverage_name(Coverage coverage);  // "detected", "MISSED", "not applicable"

CaseCoverage case_coverage(const CaseAssessment& assessment,
                           const std::vector<RowStrength>& strengths);

// By case and required detection.
reports::Table coverage_table(const std::string& id, const std::vector<CaseCoverage>& cases);

// " 22 of 26 rows declared are judged; no row judges A, B." Empty where all are judged and each
// case has one. A case none of whose runs is selected is left out.
std::string coverage_sentence(const std::vector<CaseAssessment>& cases);

}  // namespace slosh

// What each gate row of a case can detect, found out on the case's own results: gate_strength.hpp
// with the row's whole evidence behind its judge, uncertainties included.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reports/report_model.hpp"
#include "verification/campaign/case_assessment.hpp"
#include "verification/gate/gate_strength.hpp"

namespace slosh {

struct RowStrength {
  GateRow row;
  GateStrength strength;
};

// Of the rows that were judged on a series: of one that does not pass as it is, it says only that.
// The rows are tried side by side on that many threads.
std::vector<RowStrength> row_strengths(const CaseAssessment& assessment, int threads);

// Per row the smallest change that it detects, and what it does not notice at all.
reports::Table strength_table(const CaseAssessment& assessment,
                              const std::vector<RowStrength>& strengths);

// "recommended_10mm, forced amplitude_error of elevation@right: late 0.05 should be detected and is
// not", one for each claim that is not kept.
std::vector<std::string> broken_claims(const std::vector<RowStrength>& strengths);

}  // namespace slosh

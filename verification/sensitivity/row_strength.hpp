// What each gate row of a case can detect, found out on the case's own results: gate_strength.hpp
// with the row's whole evidence behind its judge, uncertainties included.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reports/model/report_model.hpp"
#include "verification/assessment/case_assessment.hpp"
#include "verification/sensitivity/gate_strength.hpp"
#include "verification/sensitivity/known_strengths.hpp"

namespace slosh {

struct RowStrength {
  GateRow row;
  GateStrength strength;
};

// What an error of the datum is measured by, in the quantity's unit: the fill depth of a length,
// the pressure under it of a pressure; 0 of a quantity without a datum.
double datum_of(const CaseDefinition& definition, const std::string& quantity);

// Of the rows that were judged on a series: of one that does not pass as it is, it says only that.
// They are tried side by side on that many threads; those that are known, null for none, are not.
std::vector<RowStrength> row_strengths(const CaseAssessment& assessment, int threads,
                                       KnownStrengths* known = nullptr);

// Per row the smallest change that it detects, and what it does not notice at all.
reports::Table strength_table(const CaseAssessment& assessment,
                              const std::vector<RowStrength>& strengths);

// "recommended_10mm, forced amplitude_error of elevation@right: late 0.05 should be detected and is
// not", one for each claim that is not kept, and one for each row that detects no change at all.
std::vector<std::string> broken_claims(const std::vector<RowStrength>& strengths);

}  // namespace slosh

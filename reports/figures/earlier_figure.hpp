// A run whose gate row does not hold, beside an earlier result of the same run.
#pragma once

#include <string>

#include "reports/model/report_model.hpp"
#include "verification/assessment/case_assessment.hpp"

namespace slosh {

// An earlier result of a gate row's candidate.
struct EarlierResult {
  RunResult result;
  std::string date;  // "2026-01-02"
  bool row_held;     // whether the row held with it
};

// Returns the time series of the row's quantity: of its reference, if it has one, of the earlier
// result and of the present one. Throws ResultError where either result of the candidate lacks the
// series.
reports::Figure earlier_figure(const CaseAssessment& assessment, const GateRow& row,
                               const EarlierResult& earlier);

}  // namespace slosh

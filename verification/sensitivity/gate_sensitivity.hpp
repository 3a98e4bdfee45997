// The sensitivity of a case's gate rows, found on the case's own results: each row judges its
// candidate spoiled on purpose (spoiled_series.hpp), with all its evidence, uncertainties included.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "verification/assessment/case_assessment.hpp"
#include "verification/sensitivity/spoiled_series.hpp"

namespace slosh {

struct RowSensitivity {
  GateRow row;
  bool passes_as_it_is;
  // Whether the row no longer passes. Empty where it does not pass as it is; without the datum
  // where the quantity has none.
  std::map<Spoiling, bool> detects;
};

// The unit of a datum error for the quantity, in the quantity's unit: the fill depth for a length,
// the pressure under it for a pressure, 0 for a quantity without a datum.
double datum_of(const CaseDefinition& definition, const std::string& quantity);

// Covers the judged rows whose candidate has the row's series. All members of an ensemble are
// spoiled alike.
std::vector<RowSensitivity> gate_sensitivity(const CaseAssessment& assessment);

// "recommended_10mm, forced amplitude_error of elevation@right"
std::string short_row_name(const GateRow& row);

// "recommended_10mm, forced amplitude_error of elevation@right: passes with NaN": the rows, but
// those of impacts, that pass with a series that ends within the window or holds NaN there.
std::vector<std::string> blind_rows(const std::vector<RowSensitivity>& sensitivity);

}  // namespace slosh

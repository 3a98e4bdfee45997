// The sensitivity of a case's gate rows, found on the case's own results: each row is put through
// the trials of mutation_trials.hpp, or of field_trials.hpp, and judged with all its evidence,
// uncertainties included.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "verification/assessment/case_assessment.hpp"
#include "verification/sensitivity/mutation_trials.hpp"
#include "verification/sensitivity/sensitivity_cache.hpp"

namespace slosh {

struct RowSensitivity {
  GateRow row;
  MutationTrials trials;
};

// Calls work(i) for i = 0 to count - 1, each once, on as many threads as the caller wants.
using ForEachIndex =
    std::function<void(std::size_t count, const std::function<void(std::size_t)>& work)>;

void one_after_another(std::size_t count, const std::function<void(std::size_t)>& work);

// The unit of a datum error for the quantity, in the quantity's unit: the fill depth for a length,
// the pressure under it for a pressure, 0 for a quantity without a datum.
double datum_of(const CaseDefinition& definition, const std::string& quantity);

// Covers the judged rows whose candidate has the row's series, and those on fields. Rows that the
// cache holds are not tried again; it may be nullptr.
std::vector<RowSensitivity> gate_sensitivity(const CaseAssessment& assessment,
                                             SensitivityCache* cache = nullptr,
                                             const ForEachIndex& for_each = one_after_another);

// "recommended_10mm, forced amplitude_error of elevation@right"
std::string short_row_name(const GateRow& row);

// "recommended_10mm, forced amplitude_error of elevation@right: late 0.05 should be detected and is
// not": one text for each claim that is broken, and one for each row that detects no change at all.
std::vector<std::string> broken_claims(const std::vector<RowSensitivity>& sensitivity);

}  // namespace slosh

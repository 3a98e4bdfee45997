// The sensitivity of a case's gate rows, found on the case's own results: each row judges its
// candidate spoiled on purpose, with all its evidence, uncertainties included. A gate that passes a
// series that is too high, late or poisoned is useless. All spoilings but a truncation keep the
// sample times, so that the coverage alone never reveals them.
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "verification/assessment/case_assessment.hpp"
#include "verification/series/time_series.hpp"

namespace slosh {

enum class Spoiling {
  amplitude,    // values times 1.1
  lag,          // ten degrees of the period late; the first value is held
  datum,        // values plus 2 % of the datum
  noise,        // white normal noise, a tenth of the values' standard deviation in the window; the
                // same at every call
  truncation,   // ends a fifth of the window before the window's end
  not_a_number  // one sample NaN, the closest to the window's middle
};

inline constexpr std::array all_spoilings{Spoiling::amplitude,  Spoiling::lag,
                                          Spoiling::datum,      Spoiling::noise,
                                          Spoiling::truncation, Spoiling::not_a_number};

std::string spoiling_name(Spoiling spoiling);  // "amplitude", ..., "NaN"

// The scales of the spoilings.
struct SpoilingFrame {
  TimeWindow window;  // of the comparison
  double period;      // [s], of the judged mode; without modes the window's length
  // In the series' unit: the fill depth, or the pressure under it; 0 where the quantity has none.
  double datum;
};

// Throws ComparisonError as cut_to_window() does for the series.
TimeSeries spoiled(TimeSeries series, Spoiling spoiling, const SpoilingFrame& frame);

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

// Series that are made wrong on purpose, which show what a gate can detect: a gate that passes a
// series that is too high, late or poisoned is useless. All but a truncated series keep their
// sample times, so that the coverage alone never reveals them.
#pragma once

#include <array>
#include <string>

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

}  // namespace slosh

// A value and its 95 % interval as text, rounded to what the interval leaves certain.
#pragma once

#include <string>

#include "verification/series/time_series.hpp"

namespace slosh {

// Returns "-0.29 ± 0.19", "6 ± 47", "(6.42 ± 0.15)e-05". The half width has one digit, or two where
// its first is 1 or 2 or where it exceeds the value, which ends at the same place. Where the value
// would then have more than four digits, the half width is rounded up to the fourth; a half width
// below a tenth of that is not shown. A value without an interval, or with one that is not shown,
// has three digits. "not determined" stands for an infinite half width.
std::string interval_text(const Estimate& estimate);

// Returns three digits: "0.0153", "158000". Powers of ten stand below 1e-4 and from 1e7 on.
std::string three_digits(double value);

// Rounds to the power of ten: to hundredths for -2. Returns no negative zero.
double round_to_place(double value, int place);

// Returns the value and its interval in per cent.
std::string percent_interval_text(const Estimate& estimate);

// Returns a slope, or "not determined" where its interval includes zero.
std::string slope_text(const Estimate& slope);

}  // namespace slosh

// What a reference cannot tell of a candidate, and the times at which the two can be compared. A
// candidate is known at the reference's times; between them the reference sees what the cubic
// through these values tells (windowed_series.hpp). Where the candidate departs from that, it has
// power beyond the reference's Nyquist frequency, or the reference has a gap.
#pragma once

#include <optional>

#include "verification/series/time_series.hpp"
#include "verification/series/windowed_series.hpp"

namespace slosh {

// Two neighbouring samples of the reference, and by how much the candidate departs at most between
// them from the cubic through its values at the reference's times.
struct UnseenInterval {
  double begin, end;  // [s]
  double departure;   // in the quantity's unit
};

// The interval of the largest departure, where that exceeds a twentieth of the candidate's largest
// departure from its mean; else the longest gap, of more than ten median intervals, with two or
// more of the candidate's samples in it; nullopt where there is neither. `common` are the samples
// at the reference's times.
std::optional<UnseenInterval> unseen_interval(const TimeSeries& candidate,
                                              const CommonSamples& common);

// The samples at the times of both series. They are `common`, those at the reference's times, where
// the reference does not resolve its own signal: where the cubic through every second sample misses
// one of the others by more than a hundredth of the largest departure from the mean. The
// candidate's times in an interval of more than two median ones, as in a dropout, are left out.
CommonSamples samples_of_both(const TimeSeries& candidate, const CommonSamples& common);

}  // namespace slosh

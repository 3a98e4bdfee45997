// What two series cannot tell of each other, and the times at which they can be compared. A
// candidate is known at the reference's times; between them the reference sees what the cubic
// through these values tells (windowed_series.hpp). Where the candidate departs from that, it has
// power beyond the reference's Nyquist frequency, or the reference has a gap. Where the candidate
// has a gap, it is not known at the reference's times.
#pragma once

#include <optional>

#include "verification/series/time_series.hpp"
#include "verification/series/windowed_series.hpp"

namespace slosh {

// Two neighbouring samples of one series, and by how much the other departs at most between them:
// the candidate from the cubic through its values at the reference's times, or the reference from
// the cubic across the candidate's gap.
struct UnseenInterval {
  double begin, end;          // [s]
  double departure;           // in the quantity's unit
  bool in_candidate = false;  // whether the candidate has no sample there; else the reference
};

// The interval of the candidate's largest departure, where that exceeds a twentieth of its largest
// departure from its mean, and what white noise of the candidate explains; else the reference's
// longest gap; or the candidate's longest gap, where the departure is larger; nullopt where there
// is none. A gap is an interval of more than ten median ones in which the other series has a sample
// that is more than a median from both ends. `common` are the samples at the reference's times.
std::optional<UnseenInterval> unseen_interval(const TimeSeries& candidate,
                                              const CommonSamples& common);

// The longest interval between two samples that meets the window, where it is more than ten median
// ones or three of the intervals at which the case records: the median is large where a series is
// sampled in bursts or thinned between its crests.
std::optional<TimeWindow> longest_gap(const TimeSeries& whole, TimeWindow window,
                                      double recorded_interval);

// The share of the window that the series covers. It does not cover an interval between two samples
// of more than a tenth of the window and of three median ones, nor more than a median one before
// its first and behind its last sample.
double covered_share(const TimeSeries& series, TimeWindow window);

// The common samples that are not inside of an interval between the candidate's samples of more
// than ten median ones.
CommonSamples outside_gaps(const TimeSeries& candidate, const CommonSamples& common);

// The samples at the times of both series. They are `common`, those at the reference's times, where
// the reference does not resolve its own signal: where the cubic through every second sample misses
// one of the others by more than a hundredth of the largest departure from the mean. The
// candidate's times in an interval of more than two median ones, as in a dropout, are left out.
CommonSamples samples_of_both(const TimeSeries& candidate, const CommonSamples& common);

}  // namespace slosh

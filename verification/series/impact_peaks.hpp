// The pressure peaks of a series of impacts, one per period. The peak of a window is the highest
// local maximum of its samples, where that exceeds the threshold; otherwise the window has no
// impact. A window includes its beginning and excludes its end. A rise or fall that the window's
// edge cuts off is no peak of that window. The values are those of the samples: a peak shorter than
// the sampling interval is missed, and for a filtered series they are the filtered ones.
#pragma once

#include <optional>
#include <vector>

#include "verification/series/time_series.hpp"

namespace slosh {

struct ImpactPeak {
  double time;      // [s]
  double pressure;  // [Pa]
};

// `count` consecutive windows of one period each, the first at `start` [s].
std::vector<TimeWindow> impact_windows(double start, double period, int count);

// One window of a quarter of a period to either side of each expected time [s].
std::vector<TimeWindow> impact_windows(const std::vector<double>& expected_times, double period);

// The pressure [Pa] above which a peak is an impact: a quarter of the lowest of the published mean
// peaks, so that it scales with the liquid and the tank of the experiment. SPHERIC benchmark 10 has
// 928 Pa in water, where the plateau after an impact is 670 Pa and the lowest of the 408 published
// peaks 2213 Pa. Throws ComparisonError where there are no mean peaks.
inline constexpr double impact_share = 0.25;
double impact_threshold(const std::vector<double>& mean_peaks);

// The peak of each window, nullopt where no peak exceeds the threshold [Pa]. Throws ComparisonError
// as cut_to_window() does per window, when a window begins before the previous one's end, when
// there are no windows, and when the threshold is not a positive finite number.
std::vector<std::optional<ImpactPeak>> impact_peaks(const TimeSeries& pressure,
                                                    const std::vector<TimeWindow>& windows,
                                                    double threshold);

// The time [s] in the window at which the pressure comes to the level [Pa] and holds it, on the
// straight line between the samples. Within a 25th of the window after each upcrossing the pressure
// is at the level or above it for some time; the arrival is the first upcrossing at which this time
// is half of the longest or more. A drop of spray holds no level, an impact does: its plateau, and
// if it has none its peak. Returns nullopt where no upcrossing is in the window. Throws
// ComparisonError as cut_to_window() does, and where the level is not a positive finite number.
//
// Measured on synthetic impacts (300 to 400 each; front and plateau of water with sound, gaps of 3
// to 8 ms behind the front, and two drops of 1 to 8 ms on average in the 0.35 s before it): the
// arrival is off by more than 20 ms in 2 %, of five drops on average in 10 %; its median error is
// -0.5 ms, half a sample. Of the rise of oil over 70 ms with noise and drops it is off by 1 ms. The
// first upcrossing is off by more than 20 ms in 83 % (bias -194 ms), of oil in 52 %; a level that
// lasts without a gap for 20 ms in 9 %; a share of 5 or 20 % of the window's impulse in 62 or 21 %,
// of oil always (bias 28 and 74 ms). A front of 18 ms before a swell, as boundary particles at 8 mm
// make it in a violent roll, is found, which 60 % of the longest in a 20th of the window would not.
// Of spray within half that 25th before the front the arrival is that of the spray. In the records
// of SPHERIC benchmark 10, water and oil, the arrival is the first upcrossing.
std::optional<double> arrival_time(const TimeSeries& pressure, TimeWindow window, double level);

// The rise time [s] of a peak: 2 (t_peak - t_half), with t_half the last time before the peak at
// which the pressure is half of it, on the straight line between the samples. It is the rise of a
// triangle with that upper half; half the peak is reached by the impact alone, where its foot is
// lost in what comes before. Returns nullopt where the pressure is never below half the peak before
// it. `peak` is one of the series' own samples.
std::optional<double> rise_time(const TimeSeries& pressure, const ImpactPeak& peak);

// The integral over the window [Pa s], by the trapezoidal rule with values on the straight line
// between the samples at its ends. Throws ComparisonError as cut_to_window() does.
double impulse(const TimeSeries& pressure, TimeWindow window);

// Mean over time (trapezoidal rule) of the samples inside a window, such as the plateau after an
// impact, in the series' unit. Throws ComparisonError as cut_to_window() does.
double plateau_mean(const TimeSeries& series, TimeWindow window);

}  // namespace slosh

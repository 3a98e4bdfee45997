// The pressure peaks of a series of impacts, one a period: in each window the highest local maximum
// of the samples, where it exceeds the threshold; otherwise that impact did not come. A window
// holds its beginning and not its end. A rise or fall that the window's edge cuts off is no peak of
// that window. The values are the samples': a peak shorter than the sampling's interval is missed,
// and of a filtered series they are the filtered ones.
#pragma once

#include <optional>
#include <vector>

#include "verification/series/time_series.hpp"

namespace slosh {

struct ImpactPeak {
  double time;      // [s]
  double pressure;  // [Pa]
};

// `count` windows of one period each, one after the other from `start` [s].
std::vector<TimeWindow> impact_windows(double start, double period, int count);

// One window a quarter of a period to both sides of each expected time [s].
std::vector<TimeWindow> impact_windows(const std::vector<double>& expected_times, double period);

// The pressure [Pa] above which a peak is an impact: a quarter of the lowest of the published mean
// peaks, so that it follows the liquid and the tank of the experiment. SPHERIC benchmark 10: 928 Pa
// in water, the plateau after an impact is 670 Pa and the lowest of the 408 published peaks 2213
// Pa. Throws ComparisonError where there are no mean peaks.
inline constexpr double impact_share = 0.25;
double impact_threshold(const std::vector<double>& mean_peaks);

// Per window its impact's peak, none where no peak exceeds the threshold [Pa]. Throws
// ComparisonError as cut_to_window() does per window, when a window begins before the last one's
// end, and when there are no windows or the threshold is not a positive number.
std::vector<std::optional<ImpactPeak>> impact_peaks(const TimeSeries& pressure,
                                                    const std::vector<TimeWindow>& windows,
                                                    double threshold);

// Mean over time (trapezoidal rule) of the samples inside a window, such as the plateau after an
// impact, in the series' unit. Throws ComparisonError as cut_to_window() does.
double plateau_mean(const TimeSeries& series, TimeWindow window);

}  // namespace slosh

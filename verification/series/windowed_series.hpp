// The part of a series that a metric uses: checked, cut to the window, resampled and detrended.
// Interpolation is the modified Akima cubic (Boost.Math's makima: local, any spacing). Its largest
// error on a sine, relative to the amplitude, is 1.0 % at 10 samples per period, 0.34 % at 20 and
// 0.015 % at 100.
#pragma once

#include <functional>
#include <vector>

#include "verification/series/time_series.hpp"

namespace slosh {

// The samples inside the window. Throws ComparisonError, with the series' name, when a time or
// value is not finite, times do not increase, the lengths differ, the window is empty, the series
// falls short of the window by more than one of its mean sample intervals, or fewer than four
// samples lie inside.
TimeSeries cut_to_window(const TimeSeries& series, TimeWindow window);

// The series with the values of a part that cut_to_window() made of it: measured over the window,
// it covers as much of it as the series does.
TimeSeries with_part(TimeSeries whole, const TimeSeries& part);

// The median time between two neighbours of at least two times [s]. Of more than 20000 every k-th
// interval counts.
double median_sample_interval(const std::vector<double>& times);

// By how much each sample between the first and the last leaves the line between its neighbours: of
// a smooth series little, of white noise 0.83 of its deviation in the median.
std::vector<double> departures_from_neighbours(const TimeSeries& series);

// Whether a checked series is constant to rounding.
bool is_constant(const TimeSeries& series);

// Throws ComparisonError when a checked series is constant to rounding: its phase and its
// normalised errors would be those of noise.
void require_variation(const TimeSeries& series);

// The cubic through the samples of a checked series, which must outlive it.
class Interpolant {
 public:
  explicit Interpolant(const TimeSeries& series) : series_(series) {}

  // Whether the time lies within the series [s].
  bool holds(double time) const {
    return time >= series_.time.front() && time <= series_.time.back();
  }
  // Values at the given times, all of which lie within the series [unit]; fast where they increase.
  std::vector<double> at(const std::vector<double>& times) const;

 private:
  const TimeSeries& series_;
  mutable std::function<double(double)> curve_;  // only made for times between samples
};

// Values of a checked series at the given times, all of which lie within it [unit].
std::vector<double> interpolate(const TimeSeries& series, const std::vector<double>& times);

// Two series at the same times.
struct CommonSamples {
  std::vector<double> time, candidate, reference;
};

// Both series at the reference's times that lie inside the candidate's span. Requires checked
// series; the reference is cut to its window, which the candidate covers to within a sample.
CommonSamples common_samples(const TimeSeries& candidate, const TimeSeries& cut_reference);

// `count` equally spaced times from begin to end, both included [s].
std::vector<double> uniform_times(double begin, double end, std::size_t count);

// Subtracts the least-squares straight line from equally spaced values.
void remove_trend(std::vector<double>& values);

}  // namespace slosh

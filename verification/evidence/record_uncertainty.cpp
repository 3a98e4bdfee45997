#include "verification/evidence/record_uncertainty.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <complex>
#include <iterator>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "verification/series/fourier_transform.hpp"
#include "verification/series/sample_moments.hpp"
#include "verification/series/windowed_series.hpp"

namespace slosh {
namespace {

const ModeComparison* find_mode(const Comparison& comparison, const std::string& mode) {
  const auto found = std::find_if(comparison.modes.begin(), comparison.modes.end(),
                                  [&](const ModeComparison& one) { return one.mode == mode; });
  return found == comparison.modes.end() ? nullptr : &*found;
}

// Each component of the wave a quarter of its period later (Hilbert's transform), at even times.
std::vector<double> in_quadrature(const TimeSeries& wave) {
  TimeSeries even = wave;
  even.time = uniform_times(wave.time.front(), wave.time.back(), wave.time.size());
  even.value = interpolate(wave, even.time);
  const auto count = std::ssize(even.value);
  const Eigen::Index length = fast_length(2 * count);
  Eigen::MatrixXd column = Eigen::Map<const Eigen::VectorXd>(even.value.data(), count);
  const Eigen::VectorXcd turned =
      fourier_transforms(column, length).col(0) * std::complex<double>(0, -1);
  const Eigen::VectorXd later = inverse_fourier_transform(turned, length);
  even.value.assign(later.begin(), later.begin() + count);
  return interpolate(even, wave.time);
}

double largest_of(const std::vector<double>& values) {
  double largest = 0;
  for (const double one : values) largest = std::max(largest, std::abs(one));
  return largest;
}

// The shapes of the header, over the half width.
std::vector<std::vector<double>> shapes_of_error(const TimeSeries& record) {
  const std::size_t count = record.value.size();
  std::vector<std::vector<double>> shapes{std::vector<double>(count, 1)};
  TimeSeries wave = record;
  wave.value = without_mean(record.value);
  const double largest = largest_of(wave.value);
  if (!(largest > 0)) return shapes;
  const double length = record.time.back() - record.time.front();
  for (const std::vector<double>& shape : {wave.value, in_quadrature(wave)}) {
    std::vector<double> constant, growing;
    for (std::size_t i = 0; i < count; ++i) {
      constant.push_back(std::clamp(shape[i] / largest, -1.0, 1.0));
      growing.push_back(constant.back() * (2 * (record.time[i] - record.time[0]) / length - 1));
    }
    shapes.push_back(constant);
    shapes.push_back(growing);
  }
  return shapes;
}

}  // namespace

double uncertainty_from_values(Metric metric, const std::string& mode, const Comparison& comparison,
                               double half_width) {
  const ModeComparison* found = find_mode(comparison, mode);
  if (!found || metric_entry(metric).fitted != FittedTones::of_both) return 0;
  const Tone& tone = found->reference;
  if (half_width >= tone.amplitude.value) return std::numeric_limits<double>::infinity();
  const double share = half_width / tone.amplitude.value;
  const double window = comparison.window.end - comparison.window.begin;
  // Of a ratio less one, where its denominator may be smaller by this share.
  const auto of_ratio = [](const Estimate& error, double smaller) {
    return smaller < 1 ? std::abs(1 + error.value) * smaller / (1 - smaller)
                       : std::numeric_limits<double>::infinity();
  };
  switch (metric) {
    case Metric::amplitude_error:
      return of_ratio(found->amplitude_error, share);
    case Metric::phase_lag:
      return 180 / std::numbers::pi * std::asin(share);
    case Metric::frequency_error:
      return of_ratio(found->frequency_error,
                      2 * std::asin(share) / (tone.angular_frequency.value * window));
    case Metric::decay_error:
      return of_ratio(found->decay_error,
                      2 * std::atanh(share) / (window * std::abs(tone.decay_rate.value)));
    default:
      throw std::logic_error("no formula for the record's uncertainty in " + metric_name(metric));
  }
}

double record_uncertainty(const GateRow& row, const TimeSeries& whole, const Comparison& comparison,
                          double half_width, const MeasureWithSeries& measure_with) {
  if (row.mode != "whole")
    return uncertainty_from_values(row.metric, row.mode, comparison, half_width);
  const TimeSeries record = cut_to_window(whole, comparison.window);
  if (row.metric != Metric::mean_offset && half_width >= largest_of(without_mean(record.value)))
    return std::numeric_limits<double>::infinity();  // it may be of nothing
  const auto change = [&](const std::vector<double>& shape, double by, double from) {
    TimeSeries moved = record;
    for (std::size_t i = 0; i < shape.size(); ++i) moved.value[i] += by * shape[i];
    const double found = measure_with(row, row.reference, with_part(whole, moved)).value - from;
    return std::abs(is_angle(row.metric) ? std::remainder(found, 360) : found);
  };
  const std::vector<std::vector<double>> shapes = shapes_of_error(record);
  const double own = measure_with(row, row.reference, whole).value;
  double largest = 0;
  for (const std::vector<double>& shape : shapes)
    for (const double by : {-half_width, half_width}) {
      const double one = change(shape, by, own);
      if (std::isnan(one)) return one;
      largest = std::max(largest, one);
    }
  return largest;
}

}  // namespace slosh

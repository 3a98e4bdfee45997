#include "verification/evidence/record_uncertainty.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "verification/series/sample_moments.hpp"

namespace slosh {
namespace {

const ModeComparison* find_mode(const Comparison& comparison, const std::string& mode) {
  const auto found = std::find_if(comparison.modes.begin(), comparison.modes.end(),
                                  [&](const ModeComparison& one) { return one.mode == mode; });
  return found == comparison.modes.end() ? nullptr : &*found;
}

// value -> value + half_width (offset + stretch (value - mean) / largest deviation)
TimeSeries moved(TimeSeries record, double half_width, double offset, double stretch) {
  const std::vector<double> deviations = without_mean(record.value);
  double largest = 0;
  for (const double one : deviations) largest = std::max(largest, std::abs(one));
  for (std::size_t i = 0; i < record.value.size(); ++i)
    record.value[i] +=
        half_width * (offset + (largest > 0 ? stretch * deviations[i] / largest : 0));
  return record;
}

}  // namespace

double uncertainty_from_values(Metric metric, const std::string& mode, const Comparison& comparison,
                               double half_width) {
  const ModeComparison* found = find_mode(comparison, mode);
  if (!found || metric_entry(metric).fitted != FittedTones::of_both) return 0;
  const Tone& tone = found->reference;
  const double share = half_width / tone.amplitude.value;
  const double window = comparison.window.end - comparison.window.begin;
  switch (metric) {
    case Metric::amplitude_error:
      return share;
    case Metric::phase_lag:
      return 180 / std::numbers::pi * share;
    case Metric::frequency_error:
      return 2 * share / (tone.angular_frequency.value * window);
    case Metric::decay_error:
      return 2 * share / (window * std::abs(tone.decay_rate.value));
    default:
      throw std::logic_error("no formula for the record's uncertainty in " + metric_name(metric));
  }
}

double record_uncertainty(const GateRow& row, const TimeSeries& record,
                          const Comparison& comparison, double half_width,
                          const MeasureWithSeries& measure_with) {
  if (row.mode != "whole")
    return uncertainty_from_values(row.metric, row.mode, comparison, half_width);
  const auto value = [&](double offset, double stretch) {
    return measure_with(row, row.reference, moved(record, half_width, offset, stretch)).value;
  };
  const double own = value(0, 0);
  double largest = 0;
  for (const double sign : {-1, 1})
    largest = std::max({largest, std::abs(value(sign, 0) - own), std::abs(value(0, sign) - own)});
  return largest;
}

}  // namespace slosh

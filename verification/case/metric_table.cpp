#include "verification/case/metric_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace slosh {
namespace {

constexpr const char* at_rest = "a candidate that does not move has -1";
constexpr const char* of_any_size =
    "nothing in a tank is as large; even a water hammer at 10 m/s has 1.5e7 Pa";

template <class Predicate>
const MetricEntry& entry_where(Predicate predicate) {
  const auto found = std::find_if(metric_table().begin(), metric_table().end(), predicate);
  if (found == metric_table().end()) throw std::logic_error("a metric that is not in the table");
  return *found;
}

}  // namespace

const std::vector<MetricEntry>& metric_table() {
  using enum MeasuredOn;
  using enum BoundScale;
  static const std::vector<MetricEntry> table{
      {Metric::amplitude_error, "amplitude_error", "1", any_mode, 1, unit, at_rest},
      {Metric::phase_lag, "phase_lag", "deg", any_mode, 180, unit,
       "a lag is known but for whole periods, so none is larger"},
      {Metric::frequency_error, "frequency_error", "1", natural_mode, 1, unit, at_rest},
      {Metric::decay_rate, "decay_rate", "1/s", natural_mode, 100, unit,
       "a mode that is gone after 0.01 s cannot be seen"},
      {Metric::decay_error, "decay_error", "1", natural_mode, 1, unit,
       "a candidate that does not decay has -1"},
      {Metric::normalised_rms, "normalised_rms", "1", whole_window, 1, unit,
       "a candidate that stays at the reference's mean has 1"},
      {Metric::maximum_residual, "maximum_residual", "", whole_window, 1e9, unit, of_any_size},
      {Metric::time_lag, "time_lag", "s", run_away, 0.25, window,
       "the lag is sought within a quarter of the window"},
      {Metric::aligned_rms, "aligned_rms", "1", run_away, 1, unit,
       "a candidate that stays at the reference's mean has 1"},
      {Metric::largest_magnitude, "largest_magnitude", "", own_series, 1e9, unit, of_any_size},
      {Metric::band_energy_error, "band_energy_error", "1", any_mode, 1, unit, at_rest},
      {Metric::cross_correlation_lag, "cross_correlation_lag", "deg", wave, 180, unit,
       "the lag is sought within half a period of the first mode"},
      {Metric::spectral_peak_error, "spectral_peak_error", "1", wave, 1, unit, at_rest},
      {Metric::rms_error, "rms_error", "1", whole_window, 1, unit, at_rest},
      {Metric::crest_error, "crest_error", "1", wave, 1, unit, at_rest},
      {Metric::trough_error, "trough_error", "1", wave, 1, unit, at_rest},
      {Metric::mean_offset, "mean_offset", "", whole_window, 1e9, unit, of_any_size},
      {Metric::noise_share, "noise_share", "1", own_series, 1, unit,
       "a series of nothing but white noise has 1"},
      {Metric::initial_value, "initial_value", "", own_series, 1e9, unit, of_any_size},
      {Metric::impact_time, "impact_time", "s", impact, 0.25, impact_period,
       "an impact is sought within a quarter of the motion's period"},
      {Metric::plateau_error, "plateau_error", "1", plateau, 1, unit,
       "a candidate without a plateau has -1"},
      {Metric::impact_percentile, "impact_percentile", "1", impact, 0.5, unit,
       "every percentile lies between 0 and 1"},
      {Metric::cost_to_reach, "cost_to_reach", "s", cost, 3.2e7, unit,
       "nobody waits for a year of one core"}};
  return table;
}

const MetricEntry& metric_entry(Metric metric) {
  return entry_where([&](const MetricEntry& entry) { return entry.metric == metric; });
}

const MetricEntry& metric_entry(const std::string& name) {
  return entry_where([&](const MetricEntry& entry) { return entry.name == name; });
}

std::string metric_name(Metric metric) { return metric_entry(metric).name; }

std::string metric_unit(Metric metric, const std::string& quantity_unit) {
  const std::string unit = metric_entry(metric).unit;
  return unit.empty() ? quantity_unit : unit;
}

bool is_of_a_pair(const MetricEntry& metric) {
  switch (metric.measured_on) {
    case MeasuredOn::any_mode:
    case MeasuredOn::natural_mode:
    case MeasuredOn::whole_window:
    case MeasuredOn::wave:
    case MeasuredOn::run_away:
      return true;
    case MeasuredOn::own_series:
    case MeasuredOn::impact:
    case MeasuredOn::plateau:
    case MeasuredOn::cost:
      return false;
  }
  throw std::logic_error("a metric that is measured on nothing");
}

bool is_of_impacts(Metric metric) {
  const MeasuredOn measured_on = metric_entry(metric).measured_on;
  return measured_on == MeasuredOn::impact || measured_on == MeasuredOn::plateau;
}

std::vector<std::string> measured_modes(const MetricEntry& metric,
                                        const std::vector<std::string>& fitted, bool runs_away) {
  std::vector<std::string> natural;
  switch (metric.measured_on) {
    case MeasuredOn::any_mode:
      return fitted;
    case MeasuredOn::natural_mode:
      std::copy_if(fitted.begin(), fitted.end(), std::back_inserter(natural),
                   [](const std::string& mode) { return mode.starts_with("natural_"); });
      return natural;
    case MeasuredOn::run_away:
      if (!runs_away) return {};
      break;
    case MeasuredOn::wave:
      if (fitted.empty()) return {};
      break;
    case MeasuredOn::impact:
      return {};
    case MeasuredOn::whole_window:
    case MeasuredOn::own_series:
    case MeasuredOn::plateau:
    case MeasuredOn::cost:
      break;
  }
  return {"whole"};
}

std::string measured_on_text(const MetricEntry& metric) {
  return fmt::format("what {} is measured on", metric.name);
}

double widest_bound(const MetricEntry& metric, const BoundScales& scales) {
  switch (metric.scale) {
    case BoundScale::unit:
      return metric.below;
    case BoundScale::window:
      return metric.below * scales.window;
    case BoundScale::impact_period:
      return metric.below * scales.impact_period;
  }
  throw std::logic_error("a bound of no scale");
}

Rule<double> limit_rule(const MetricEntry& metric, const std::string& unit,
                        const BoundScales& scales) {
  const double widest = widest_bound(metric, scales);
  return {fmt::format("a number > 0 and below {:.4g}, {} ({})", widest, in(unit), metric.because),
          [widest](double value) { return value > 0 && value < widest; }};
}

}  // namespace slosh

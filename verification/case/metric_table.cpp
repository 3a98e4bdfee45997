#include "verification/case/metric_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>

namespace slosh {
namespace {

constexpr const char* at_rest = "a candidate that does not move has -1";
constexpr const char* of_any_size =
    "no elevation exceeds the tank's size, and no pressure the water hammer of a fall through it";
constexpr RequiredBound any_bound{BoundForm::any, ""},
    limit_alone{BoundForm::limit, "cheaper is better"},
    frequency_range{BoundForm::range, "a frequency may be too low and too high"},
    p_value_range{BoundForm::range, "a p-value must be large enough, and at most 1"};
constexpr const char* between_0_and_1 = "every p-value lies between 0 and 1";

constexpr std::array<MetricEntry, metric_count> metric_rows() {
  using enum MeasuredOn;
  using enum ConvergenceShown;
  using enum BoundScale;
  using enum BlindTo;
  using Fit = FittedTones;
  using below = WidestBound;
  return {
      {{Metric::amplitude_error, "amplitude_error", "1", "error of the amplitude", any_mode,
        Fit::of_both, sign, of_forced_mode, any_bound, below(1, unit, at_rest, -1)},
       {Metric::phase_lag, "phase_lag", "deg", "phase lag", any_mode, Fit::of_both, nothing,
        of_forced_mode, any_bound,
        below(180, unit, "a lag is known but for whole periods, so none is larger", 180)},
       {Metric::frequency_error, "frequency_error", "1", "error of the frequency", natural_mode,
        Fit::of_both, nothing, of_natural_modes, any_bound,
        below(0.22, unit, "both frequencies are sought within a tenth of theory's")},
       {Metric::decay_rate, "decay_rate", "1/s", "decay rate", natural_mode, Fit::of_candidate,
        nothing, of_natural_modes, any_bound,
        below(100, unit, "a mode that is gone after 0.01 s cannot be seen")},
       {Metric::decay_error, "decay_error", "1", "error of the decay rate", natural_mode,
        Fit::of_both, nothing, nowhere, any_bound,
        below(1, unit, "a candidate that does not decay has -1", -1)},
       {Metric::normalised_rms, "normalised_rms", "1", "normalised rms of the difference",
        whole_window, Fit::none, side, of_oscillation, any_bound,
        below(1, unit, "a candidate that stays at the reference's mean has 1", 1)},
       {Metric::aligned_rms, "aligned_rms", "1",
        "normalised rms of the difference without the time lag", front, Fit::none, side, of_front,
        any_bound, below(1, unit, "a candidate that stays at the reference's mean has 1", 1)},
       {Metric::largest_magnitude, "largest_magnitude", "", "largest magnitude", own_series,
        Fit::none, sign, nowhere, any_bound, below(1, tank, of_any_size)},
       {Metric::cross_correlation_lag, "cross_correlation_lag", "deg",
        "lag of the highest cross-correlation", oscillation, Fit::none, nothing, nowhere, any_bound,
        below(180, unit, "the lag is sought within half a period of the first mode", 180)},
       {Metric::spectral_peak_error, "spectral_peak_error", "1",
        "error of the frequency of the highest spectral peak", oscillation, Fit::none, nothing,
        nowhere, any_bound, below(1, unit, at_rest, -1)},
       {Metric::rms_error, "rms_error", "1", "error of the root mean square about the mean",
        whole_window, Fit::none, sign, nowhere, any_bound, below(1, unit, at_rest, -1)},
       {Metric::mean_offset, "mean_offset", "", "mean less the reference's", whole_window,
        Fit::none, nothing, nowhere, any_bound, below(1, tank, of_any_size)},
       {Metric::noise_share, "noise_share", "1", "white noise over the standard deviation",
        own_series, Fit::none, nothing, nowhere, any_bound,
        below(1, unit, "a series of nothing but white noise has 1", 1)},
       {Metric::initial_value, "initial_value", "", "value at the start", own_series, Fit::none,
        nothing, nowhere, any_bound, below(1, tank, of_any_size)},
       {Metric::frequency, "frequency", "Hz", "frequency", own_mode, Fit::of_candidate, nothing,
        nowhere, frequency_range, below(100, unit, "no wave of a tank is as fast")},
       {Metric::plateau_error, "plateau_error", "1", "error of the mean over the plateau", plateau,
        Fit::none, nothing, nowhere, any_bound,
        below(1, unit, "a candidate without a plateau has -1", -1)},
       {Metric::impact_arrival, "impact_arrival", "s", "time of the arrival less the published one",
        impact, Fit::none, nothing, nowhere, any_bound,
        below(0.25, impact_period, "an impact is sought within a quarter of the motion's period")},
       {Metric::impact_peak_error, "impact_peak_error", "1", "error of the peak of an impact",
        impact, Fit::none, nothing, nowhere, any_bound,
        below(1, unit, "a candidate without an impact has -1", -1)},
       {Metric::impulse_error, "impulse_error", "1", "error of the impulse of an impact", impact,
        Fit::none, nothing, nowhere, any_bound,
        below(1, unit, "a candidate without an impact has -1", -1)},
       {Metric::peak_mean_p_value, "peak_mean_p_value", "1",
        "p-value of equal mean peaks of the ensemble and of the experiment's repeats, by Welch",
        repeated_impact, Fit::none, nothing, nowhere, p_value_range,
        below(0.5, unit, between_0_and_1, 0)},
       {Metric::peak_ks_p_value, "peak_ks_p_value", "1",
        "p-value of equal distributions of the peaks, by Kolmogorov and Smirnov", repeated_impact,
        Fit::none, nothing, nowhere, p_value_range, below(0.5, unit, between_0_and_1, 0)},
       {Metric::peak_ad_p_value, "peak_ad_p_value", "1",
        "p-value of equal distributions of the peaks, by Anderson and Darling", repeated_impact,
        Fit::none, nothing, nowhere, p_value_range, below(0.5, unit, between_0_and_1, 0)},
       {Metric::peak_median_error, "peak_median_error", "1",
        "error of the median of the peaks over the ensemble", repeated_impact, Fit::none, nothing,
        nowhere, any_bound, below(1, unit, "a candidate whose peaks are all zero has -1", -1)},
       {Metric::outside_band, "outside_band", "1", "share of the time outside the record's band",
        band, Fit::none, side, nowhere, any_bound,
        below(1, unit, "a candidate that is never inside has 1", 1)},
       {Metric::pressure_field_rms, "pressure_field_rms", "1",
        "rms difference of the pressure field over the pressure under the fill depth", field,
        Fit::none, nothing, nowhere, any_bound,
        below(0.5, unit, "without pressure a candidate has 0.58 against a liquid at rest", 0.58)},
       {Metric::pressure_field_tension, "pressure_field_tension", "1",
        "share of the liquid under tension", field, Fit::none, nothing, nowhere, any_bound,
        below(1, unit, "a liquid that is all under tension has 1", 1)},
       {Metric::cost_to_reach, "cost_to_reach", "s", "processor time to reach an error", cost,
        Fit::none, nothing, nowhere, limit_alone,
        below(3.2e7, unit, "nobody waits for a year of one core")}}};
}

constexpr std::array<MetricEntry, metric_count> metrics = metric_rows();

enum class Modes { fitted, natural, impacts, whole };

Modes modes_of(const MetricEntry& metric) {
  switch (metric.measured_on) {
    case MeasuredOn::any_mode:
      return Modes::fitted;
    case MeasuredOn::natural_mode:
    case MeasuredOn::own_mode:
      return Modes::natural;
    case MeasuredOn::impact:
    case MeasuredOn::repeated_impact:
      return Modes::impacts;
    case MeasuredOn::whole_window:
    case MeasuredOn::oscillation:
    case MeasuredOn::front:
    case MeasuredOn::band:
    case MeasuredOn::own_series:
    case MeasuredOn::plateau:
    case MeasuredOn::field:
    case MeasuredOn::cost:
      return Modes::whole;
  }
  throw std::logic_error("a metric that is measured on nothing");
}

constexpr bool are_in_the_order_of_the_enumeration() {
  for (std::size_t i = 0; i < metrics.size(); ++i)
    if (metrics[i].metric != static_cast<Metric>(i)) return false;
  return true;
}
static_assert(are_in_the_order_of_the_enumeration());

}  // namespace

const std::array<MetricEntry, metric_count>& metric_table() { return metrics; }

const MetricEntry& metric_entry(Metric metric) {
  return metrics.at(static_cast<std::size_t>(metric));
}

const MetricEntry& metric_entry(const std::string& name) {
  const auto found = std::find_if(metrics.begin(), metrics.end(),
                                  [&](const MetricEntry& entry) { return entry.name == name; });
  if (found == metrics.end()) throw std::logic_error("the table has no metric " + name);
  return *found;
}

std::string metric_name(Metric metric) { return metric_entry(metric).name; }

std::string metric_unit(Metric metric, const std::string& quantity_unit) {
  const std::string unit = metric_entry(metric).unit;
  return unit.empty() ? quantity_unit : unit;
}

bool is_of_a_pair(const MetricEntry& metric) {
  using enum MeasuredOn;
  constexpr MeasuredOn of_pairs[] = {any_mode,    natural_mode, whole_window,
                                     oscillation, front,        band};
  return std::ranges::count(of_pairs, metric.measured_on) > 0;
}

bool is_of_candidate_alone(Metric metric) {
  const MeasuredOn measured_on = metric_entry(metric).measured_on;
  return measured_on == MeasuredOn::own_series || measured_on == MeasuredOn::own_mode;
}

bool is_of_impacts(Metric metric) {
  const MeasuredOn measured_on = metric_entry(metric).measured_on;
  return measured_on == MeasuredOn::impact || measured_on == MeasuredOn::plateau ||
         is_of_repeats(metric);
}

bool is_of_repeats(Metric metric) {
  return metric_entry(metric).measured_on == MeasuredOn::repeated_impact;
}

bool is_p_value(Metric metric) {
  return is_of_repeats(metric) && metric_entry(metric).bound.form == BoundForm::range;
}

bool is_of_band(Metric metric) { return metric_entry(metric).measured_on == MeasuredOn::band; }
bool is_of_fields(Metric metric) { return metric_entry(metric).measured_on == MeasuredOn::field; }

bool is_cost(Metric metric) { return metric_entry(metric).measured_on == MeasuredOn::cost; }

bool is_angle(Metric metric) { return metric_entry(metric).unit == std::string("deg"); }

std::vector<std::string> measured_modes(const MetricEntry& metric,
                                        const std::vector<std::string>& fitted, bool is_front) {
  std::vector<std::string> natural;
  switch (modes_of(metric)) {
    case Modes::fitted:
      return fitted;
    case Modes::natural:
      std::copy_if(fitted.begin(), fitted.end(), std::back_inserter(natural),
                   [](const std::string& mode) { return mode.starts_with("natural_"); });
      return natural;
    case Modes::impacts:
      return {};
    case Modes::whole:
      break;
  }
  const bool has_none = (metric.measured_on == MeasuredOn::front && !is_front) ||
                        (metric.measured_on == MeasuredOn::oscillation && fitted.empty());
  return has_none ? std::vector<std::string>{} : std::vector<std::string>{"whole"};
}

std::optional<std::string> default_mode(const MetricEntry& metric) {
  if (modes_of(metric) == Modes::fitted) return "forced";
  if (modes_of(metric) == Modes::whole) return "whole";
  return std::nullopt;
}

std::string measured_on_text(const MetricEntry& metric) {
  return fmt::format("what {} is measured on", metric.name);
}

double widest_bound(const MetricEntry& metric, const BoundScales& scales) {
  switch (metric.widest.scale) {
    case BoundScale::unit:
      return metric.widest.below;
    case BoundScale::window:
      return metric.widest.below * scales.window;
    case BoundScale::impact_period:
      return metric.widest.below * scales.impact_period;
    case BoundScale::tank:
      return metric.widest.below * scales.tank;
  }
  throw std::logic_error("a bound of no scale");
}

Rule<double> limit_rule(const MetricEntry& metric, const std::string& unit,
                        const BoundScales& scales) {
  const double widest = widest_bound(metric, scales);
  return {fmt::format("a number > 0 and below {:.4g}, {} ({})", widest, in(unit),
                      metric.widest.because),
          [widest](double value) { return value > 0 && value < widest; }};
}

Rule<double> upper_rule(const MetricEntry& metric, const std::string& unit,
                        const BoundScales& scales, double lower) {
  const double widest = lower + 2 * widest_bound(metric, scales), nothing = metric.widest.nothing;
  const double turn = is_angle(metric.metric) ? 360 : 0;
  // The least value of nothing that is no less than the lower end.
  const double next = turn > 0 ? nothing + turn * std::ceil((lower - nothing) / turn) : nothing;
  const double end = next >= lower ? std::min(widest, next) : widest;
  return {
      fmt::format("a number above lower ({}) and below {:.4g}, {}{} ({})", lower, end, in(unit),
                  end < widest ? fmt::format(", so that the range does not hold {:g}", end) : "",
                  metric.widest.because),
      [lower, end](double value) { return value > lower && value < end; }};
}

}  // namespace slosh

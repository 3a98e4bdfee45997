#include "verification/gate/own_series.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "verification/case/metric_table.hpp"
#include "verification/case/quantities.hpp"
#include "verification/gate/measured_value.hpp"

namespace slosh {
namespace {

constexpr double usual_scatter = 2;   // another run's peak over one run's
constexpr double least_crest = 0.03;  // of a wave's period
constexpr double top = 0.9;           // of a peak

// As in_unit() of gate.hpp.
std::string shown(double value, const std::string& unit) {
  return unit == "1" ? fmt::format("{:.3g} %", 100 * value) : fmt::format("{:.3g} {}", value, unit);
}

std::string span_text(const TimeSeries& series) {
  return fmt::format("{:.4g} to {:.4g} s", series.time.front(), series.time.back());
}

// The member with the largest magnitude.
std::string highest_member(const GateRow& row, const GateEvidence& evidence) {
  std::string highest;
  double most = -1;
  for (const std::string& run : ensemble_of(row.candidate, evidence).members)
    if (const double one = largest_of(evidence.series(run, row.quantity)).magnitude; one > most) {
      most = one;
      highest = run;
    }
  return highest;
}

std::string outside_text(const TimeSeries& whole, const TimeSeries& judged, double magnitude,
                         const std::string& unit) {
  TimeSeries outside;
  for (std::size_t i = 0; i < std::min(whole.time.size(), whole.value.size()); ++i)
    if (whole.time[i] < judged.time.front() || whole.time[i] > judged.time.back()) {
      outside.time.push_back(whole.time[i]);
      outside.value.push_back(whole.value[i]);
    }
  const Peak larger = largest_of(outside);
  if (!(larger.magnitude > magnitude)) return "";
  return fmt::format("; LARGER outside of that time: {} at {:.4g} s", shown(larger.magnitude, unit),
                     larger.time);
}

// The time [s] for which the series stays at the top of its largest magnitude.
double width_of(const TimeSeries& series) {
  const Peak peak = largest_of(series);
  const auto at = static_cast<std::size_t>(
      std::find(series.time.begin(), series.time.end(), peak.time) - series.time.begin());
  if (at >= series.value.size()) return not_a_number;
  const auto is_high = [&](std::size_t i) {
    return series.value[i] / series.value[at] > top;  // of the same sign
  };
  std::size_t first = at, last = at;
  while (first > 0 && is_high(first - 1)) --first;
  while (last + 1 < series.value.size() && is_high(last + 1)) ++last;
  return series.time[last] - series.time[first];
}

bool is_peak(const GateRow& row) {
  return row.metric == Metric::impact_peak_error || row.metric == Metric::impulse_error ||
         (row.metric == Metric::largest_magnitude && find_quantity(row.quantity) != nullptr);
}

// Whether a bound lies within the scatter. Errors of impacts are ratios, less 1.
bool may_cross_a_bound(const GateRow& row, double value, double scatter,
                       const AllowedRange& allowed) {
  const double one = is_of_impacts(row.metric) ? 1 : 0;
  const double low = (value + one) / scatter - one, high = (value + one) * scatter - one;
  const auto is_within = [&](double bound) { return low < bound && bound < high; };
  return is_within(allowed.lower) || is_within(allowed.upper);
}

}  // namespace

std::string place_text(const GateRow& row, const GateEvidence& evidence) {
  if (row.metric == Metric::noise_share)
    return fmt::format("; over {}", span_text(evidence.series(row.candidate, row.quantity)));
  if (row.metric != Metric::largest_magnitude) return "";
  const std::string run = highest_member(row, evidence);
  if (run.empty()) return "";  // NaN
  const TimeSeries series = evidence.series(run, row.quantity);
  const Peak peak = largest_of(series);
  return fmt::format(
      "; {}at {:.4g} s of {}{}",
      is_of_ensembles(row, evidence)
          ? fmt::format("the highest member has {} ", shown(peak.magnitude, row.unit))
          : "",
      peak.time, span_text(series),
      evidence.history
          ? outside_text(evidence.history(run, row.quantity), series, peak.magnitude, row.unit)
          : "");
}

RowDoubts single_run_doubts(const GateRow& row, double value, const AllowedRange& allowed,
                            const GateEvidence& evidence) {
  const EnsembleOfRun runs = ensemble_of(row.candidate, evidence);
  if (!is_peak(row) || runs.exact || runs.members.size() > 1) return {};
  const bool is_impact =
      is_of_impacts(row.metric) || !(width_of(evidence.series(row.candidate, row.quantity)) >=
                                     least_crest * evidence.wave_period);
  if (!is_impact) return {"; single run", false};
  const double scatter =
      (evidence.peak_scatter ? evidence.peak_scatter(row) : std::nullopt).value_or(usual_scatter);
  const bool is_near =
      row.metric != Metric::impulse_error && may_cross_a_bound(row, value, scatter, allowed);
  return {
      fmt::format(
          "; single run: {}`repeats` of {} would tell how it scatters",
          is_near ? fmt::format("another run's peak may be {:.3g} times as high or low; ", scatter)
                  : "",
          row.candidate),
      is_near};
}

}  // namespace slosh

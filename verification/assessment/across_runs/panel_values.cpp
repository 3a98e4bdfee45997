#include "verification/assessment/across_runs/panel_values.hpp"

#include <algorithm>
#include <numbers>
#include <optional>

#include "verification/case/quantities.hpp"
#include "verification/evidence/case_evidence.hpp"
#include "verification/gate/impact_metrics.hpp"
#include "verification/metrics/time_alignment.hpp"
#include "verification/series/sample_moments.hpp"
#include "verification/series/windowed_series.hpp"

namespace slosh {
namespace {

TimeWindow window_of(const CaseDefinition& definition) {
  return {definition.window_begin, definition.window_end};
}

std::optional<double> peak_of(const PanelQuestion& question, const TimeSeries& series) {
  const std::size_t n = impact_number(question.mode, question.definition);
  const std::optional<ImpactPeak> peak = impacts_in(series, question.definition).at(n);
  return peak ? std::optional(peak->pressure) : std::nullopt;
}

std::optional<double> arrival_of(const PanelQuestion& question, const TimeSeries& series) {
  return arrival_in(series, impact_number(question.mode, question.definition), question.definition);
}

std::optional<double> impulse_of(const PanelQuestion& question, const TimeSeries& series) {
  const std::optional<double> arrival = arrival_of(question, series);
  if (!arrival) return std::nullopt;
  return impulse(series, {*arrival, *arrival + question.panel.impulse_duration.value()});
}

double plateau_of(const PanelQuestion& question, const TimeSeries& series) {
  const ImpactsDefinition& impacts = question.definition.impacts.value();
  return plateau_mean(series, {impacts.plateau_begin, impacts.plateau_end});
}

double lag_of(const PanelQuestion& question, const TimeSeries& series) {
  if (!question.history) throw ComparisonError("the solvers have no history in common");
  const TimeWindow window = window_of(question.definition);
  const std::vector<ToneRequest> modes = fitted_modes(question.definition);
  if (has_modes(question.panel.quantity) && !modes.empty())
    return cross_correlation_lag(series, *question.history, window,
                                 2 * std::numbers::pi / modes.front().angular_frequency);
  return align_in_time(cut_to_window(series, window), *question.history).lag;
}

}  // namespace

TimeSeries mean_history(const std::vector<std::vector<TimeSeries>>& solvers) {
  const TimeSeries* first = nullptr;
  double begin = 0, end = 0, votes = 0;
  for (const auto& members : solvers) {
    votes += members.empty() ? 0 : 1;
    for (const TimeSeries& one : members) {
      begin = first ? std::max(begin, one.time.front()) : one.time.front();
      end = first ? std::min(end, one.time.back()) : one.time.back();
      if (!first) first = &one;
    }
  }
  if (!first || !(begin < end)) throw ComparisonError("the solvers have no history in common");
  TimeSeries history{first->name, first->unit, uniform_times(begin, end, first->time.size()), {}};
  history.value.assign(history.time.size(), 0);
  for (const auto& members : solvers)
    for (const TimeSeries& one : members) {
      const std::vector<double> values = interpolate(one, history.time);
      const double weight = 1 / (votes * static_cast<double>(members.size()));
      for (std::size_t i = 0; i < values.size(); ++i) history.value[i] += weight * values[i];
    }
  return history;
}

double panel_value(const PanelQuestion& question, const TimeSeries& series) {
  switch (question.metric) {
    case PanelMetric::impact_peak:
      return peak_of(question, series).value_or(not_a_number);
    case PanelMetric::impact_arrival:
      return arrival_of(question, series).value_or(not_a_number);
    case PanelMetric::impulse:
      return impulse_of(question, series).value_or(not_a_number);
    case PanelMetric::plateau:
      return plateau_of(question, series);
    case PanelMetric::rms:
      return rms(without_mean(cut_to_window(series, window_of(question.definition)).value));
    case PanelMetric::lag:
      return lag_of(question, series);
  }
  throw std::logic_error("a metric of a panel without a value");
}

}  // namespace slosh

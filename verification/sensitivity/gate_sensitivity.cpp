#include "verification/sensitivity/gate_sensitivity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <random>
#include <stdexcept>

#include "verification/case/ensemble.hpp"
#include "verification/case/metric_table.hpp"
#include "verification/case/quantities.hpp"
#include "verification/evidence/case_evidence.hpp"
#include "verification/gate/impact_metrics.hpp"
#include "verification/series/sample_moments.hpp"
#include "verification/series/windowed_series.hpp"

namespace slosh {
namespace {

constexpr double scale = 1.1;
constexpr double lag_in_periods = 10.0 / 360;
constexpr double part_of_datum = 0.02;
constexpr double part_of_deviation = 0.1;
constexpr double part_of_window = 0.2;
constexpr std::uint64_t noise_seed = 20090401;  // arbitrary; fixed, so that reports repeat

void delay(TimeSeries& series, double lag) {
  std::vector<double> times(series.time.size());
  std::transform(series.time.begin(), series.time.end(), times.begin(),
                 [&](double t) { return std::max(t - lag, series.time.front()); });
  series.value = interpolate(series, times);
}

void add_white_noise(TimeSeries& series, double deviation) {
  std::mt19937_64 generator(noise_seed);
  std::normal_distribution<double> normal;
  for (double& value : series.value) value += deviation * normal(generator);
}

void end_at(TimeSeries& series, double last_time) {
  const auto kept = static_cast<std::size_t>(
      std::upper_bound(series.time.begin(), series.time.end(), last_time) - series.time.begin());
  series.time.resize(kept);
  series.value.resize(kept);
}

void poison_at(TimeSeries& series, double time) {
  const auto nearest = std::min_element(
      series.time.begin(), series.time.end(),
      [time](double a, double b) { return std::abs(a - time) < std::abs(b - time); });
  series.value[static_cast<std::size_t>(nearest - series.time.begin())] = not_a_number;
}

}  // namespace

std::string spoiling_name(Spoiling spoiling) {
  switch (spoiling) {
    case Spoiling::amplitude:
      return "amplitude";
    case Spoiling::lag:
      return "lag";
    case Spoiling::datum:
      return "datum";
    case Spoiling::noise:
      return "noise";
    case Spoiling::truncation:
      return "truncation";
    case Spoiling::not_a_number:
      return "NaN";
  }
  throw std::logic_error("a spoiling without a name");
}

TimeSeries spoiled(TimeSeries series, Spoiling spoiling, const SpoilingFrame& frame) {
  const auto [begin, end] = frame.window;
  const TimeSeries judged = cut_to_window(series, frame.window);
  switch (spoiling) {
    case Spoiling::amplitude:
      for (double& value : series.value) value *= scale;
      break;
    case Spoiling::lag:
      delay(series, lag_in_periods * frame.period);
      break;
    case Spoiling::datum:
      for (double& value : series.value) value += part_of_datum * frame.datum;
      break;
    case Spoiling::noise:
      add_white_noise(series, part_of_deviation * rms(without_mean(judged.value)));
      break;
    case Spoiling::truncation:
      end_at(series, end - part_of_window * (end - begin));
      break;
    case Spoiling::not_a_number:
      poison_at(series, std::midpoint(begin, end));
      break;
  }
  return series;
}

namespace {

SpoilingFrame frame_of(const CaseDefinition& of, const GateRow& row) {
  const CaseDefinition definition = judged_over(row, of);
  const bool has_reference = !row.reference.empty() && !is_of_impacts(row.metric);
  const TimeWindow window = has_reference
                                ? compared_window(definition, row.reference)
                                : TimeWindow{definition.window_begin, definition.window_end};
  SpoilingFrame frame{window, window.end - window.begin, datum_of(definition, row.quantity)};
  const std::vector<ToneRequest> modes = fitted_modes(definition);
  if (modes.empty()) return frame;
  const auto own = std::find_if(modes.begin(), modes.end(),
                                [&](const ToneRequest& mode) { return mode.name == row.mode; });
  const ToneRequest& mode = own == modes.end() ? modes.front() : *own;
  frame.period = 2 * std::numbers::pi / mode.angular_frequency;
  return frame;
}

bool can_be_spoiled(const CaseAssessment& assessment, const GateOutcome& outcome) {
  return is_judged(outcome.verdict) && !is_of_fields(outcome.row.metric) &&
         has_series(assessment.runs, outcome.row.candidate, outcome.row.quantity);
}

// The fitted comparisons that hold none of these runs.
FittedComparisons without(const std::vector<std::string>& runs, FittedComparisons fitted) {
  const auto is_left_out = [&](const std::string& run) {
    return std::find(runs.begin(), runs.end(), run) != runs.end();
  };
  std::erase_if(fitted.of, [&](const auto& one) {
    return is_left_out(one.first[0]) || is_left_out(one.first[1]);
  });
  std::erase_if(fitted.series,
                [&](const auto& one) { return is_left_out(std::get<1>(one.first)); });
  return fitted;
}

// The judged part of all runs, with the candidate's members spoiled.
CaseRuns with_spoiled(const CaseAssessment& assessment, const GateRow& row, Spoiling spoiling,
                      const SpoilingFrame& frame) {
  CaseRuns runs{assessment.runs.status, {}, assessment.runs.timings};
  if (is_of_band(row.metric)) runs.input_bounds = assessment.runs.input_bounds;
  for (const auto& [run, result] : assessment.runs.results)
    runs.results[run] = judged_part(result, row.quantity);
  for (const std::string& member : members_of(assessment.definition, row.candidate))
    for (TimeSeries& series : runs.results.at(member).series)
      if (series.name == row.quantity) series = spoiled(series, spoiling, frame);
  return runs;
}

RowSensitivity sensitivity_of(const CaseAssessment& assessment, const GateOutcome& outcome) {
  const GateRow& row = outcome.row;
  RowSensitivity found{row, outcome.verdict == Verdict::pass, {}};
  if (!found.passes_as_it_is) return found;
  const SpoilingFrame frame = frame_of(assessment.definition, row);
  const FittedComparisons known =
      without(members_of(assessment.definition, row.candidate), assessment.fitted);
  for (const Spoiling spoiling : all_spoilings) {
    if (spoiling == Spoiling::datum && frame.datum == 0) continue;
    const CaseRuns runs = with_spoiled(assessment, row, spoiling, frame);
    CaseEvidence evidence(assessment.definition, runs, &known, modes_needed_by({row}));
    found.detects[spoiling] = evidence.judge(row).verdict != Verdict::pass;
  }
  return found;
}

}  // namespace

double datum_of(const CaseDefinition& definition, const std::string& quantity) {
  const Quantity* known = find_quantity(quantity);
  const std::string unit = known ? known->unit : "";
  const double depth = definition.liquid.fill_depth;
  if (unit == "Pa") return definition.liquid.density * definition.gravity * depth;
  return unit == "m" ? depth : 0;
}

std::vector<RowSensitivity> gate_sensitivity(const CaseAssessment& assessment) {
  std::vector<RowSensitivity> sensitivity;
  for (const GateOutcome& outcome : assessment.gate)
    if (can_be_spoiled(assessment, outcome))
      sensitivity.push_back(sensitivity_of(assessment, outcome));
  return sensitivity;
}

std::string short_row_name(const GateRow& row) {
  return fmt::format("{}, {} {} of {}", row.candidate, row.mode, measured_name(row), row.quantity);
}

std::vector<std::string> blind_rows(const std::vector<RowSensitivity>& sensitivity) {
  std::vector<std::string> blind;
  for (const auto& [row, passes, detects] : sensitivity) {
    if (is_of_impacts(row.metric)) continue;
    for (const auto& [spoiling, detected] : detects)
      if (!detected && (spoiling == Spoiling::truncation || spoiling == Spoiling::not_a_number))
        blind.push_back(
            fmt::format("{}: passes with {}", short_row_name(row), spoiling_name(spoiling)));
  }
  return blind;
}

}  // namespace slosh

#include "verification/sensitivity/gate_sensitivity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "verification/case/ensemble.hpp"
#include "verification/case/metric_table.hpp"
#include "verification/case/quantities.hpp"
#include "verification/evidence/case_evidence.hpp"
#include "verification/gate/impact_metrics.hpp"

namespace slosh {
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

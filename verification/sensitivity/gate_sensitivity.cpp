#include "verification/sensitivity/gate_sensitivity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numbers>

#include "verification/case/ensemble.hpp"
#include "verification/case/quantities.hpp"
#include "verification/evidence/case_evidence.hpp"
#include "verification/gate/impact_metrics.hpp"
#include "verification/sensitivity/field_trials.hpp"

namespace slosh {
namespace {

// The frame of a row's mutations, without the fitted modes.
MutationFrame frame_of(const CaseDefinition& definition, const GateRow& row) {
  const bool has_reference = !row.reference.empty() && !is_of_impacts(row.metric);
  const TimeWindow window = has_reference
                                ? compared_window(definition, row.reference)
                                : TimeWindow{definition.window_begin, definition.window_end};
  MutationFrame frame{window, window.end - window.begin, datum_of(definition, row.quantity)};
  const std::vector<ToneRequest> modes = fitted_modes(definition);
  if (modes.empty()) return frame;
  const auto own = std::find_if(modes.begin(), modes.end(),
                                [&](const ToneRequest& mode) { return mode.name == row.mode; });
  const ToneRequest& mode = own == modes.end() ? modes.front() : *own;
  frame.period = 2 * std::numbers::pi / mode.angular_frequency;
  return frame;
}

// The modes are left out where the window cannot resolve them.
MutationFrame with_modes(MutationFrame frame, const CaseDefinition& definition,
                         const TimeSeries& series) try {
  const std::vector<ToneRequest> modes = fitted_modes(definition);
  if (modes.empty() || !has_modes(series.name)) return frame;
  frame.tones = fit_harmonics(series, frame.window, modes).tones;
  frame.modes = modes;
  return frame;
} catch (const ComparisonError&) {
  return frame;
}

TimeSeries& series_of(RunResult& result, const std::string& quantity) {
  return *std::find_if(result.series.begin(), result.series.end(),
                       [&](const TimeSeries& one) { return one.name == quantity; });
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

// Rows that judge one series in one frame: each mutant is compared once for all of them.
struct RowGroup {
  MutationFrame frame;
  std::vector<std::size_t> rows;  // of the case's gate
};

std::vector<MutationTrials> trials_of(const CaseAssessment& assessment, const RowGroup& group) {
  std::vector<TriedRow> rows;
  for (const std::size_t i : group.rows)
    rows.push_back({assessment.gate[i].row, assessment.gate[i].value.value});
  const std::string &candidate = rows.front().row.candidate, &quantity = rows.front().row.quantity;
  CaseRuns runs{assessment.runs.status, {}, assessment.runs.timings};
  for (const auto& [run, result] : assessment.runs.results)
    runs.results[run] = judged_part(result, quantity);
  const std::vector<std::string> members = members_of(assessment.definition, candidate);
  const FittedComparisons known = without(members, assessment.fitted);
  const auto own = [&](const std::string& run) -> const TimeSeries& {
    return assessment.runs.results.at(run).at(quantity);
  };
  std::vector<GateRow> judged;
  for (const TriedRow& one : rows) judged.push_back(one.row);
  const NeededModes needed = modes_needed_by(judged);
  std::map<std::string, MutationFrame> frames;
  for (const std::string& run : members)
    frames[run] = run == candidate ? group.frame
                                   : with_modes(frame_of(assessment.definition, rows.front().row),
                                                assessment.definition, own(run));
  const JudgeRows judge = [&](const Mutation* mutation) {
    for (const std::string& run : members)
      series_of(runs.results.at(run), quantity) =
          mutation ? mutated(own(run), *mutation, frames.at(run)) : own(run);
    CaseEvidence evidence(assessment.definition, runs, &known, needed);
    std::vector<Verdict> verdicts;
    for (const TriedRow& one : rows) verdicts.push_back(evidence.judge(one.row).verdict);
    return verdicts;
  };
  return try_mutations(rows, own(candidate), group.frame, judge);
}

bool can_be_mutated(const CaseAssessment& assessment, const GateOutcome& outcome) {
  if (is_of_fields(outcome.row.metric)) return is_judged(outcome.verdict);
  return is_judged(outcome.verdict) &&
         has_series(assessment.runs, outcome.row.candidate, outcome.row.quantity);
}

bool have_one_frame(const MutationFrame& a, const MutationFrame& b) {
  return a.window.begin == b.window.begin && a.window.end == b.window.end && a.period == b.period;
}

// The groups of the rows with these indices in the case's gate.
std::vector<RowGroup> groups_of(const CaseAssessment& assessment,
                                const std::vector<std::size_t>& rows) {
  std::vector<RowGroup> groups;
  for (const std::size_t i : rows) {
    const GateRow& row = assessment.gate[i].row;
    const MutationFrame frame = frame_of(assessment.definition, row);
    const auto found = std::find_if(groups.begin(), groups.end(), [&](const RowGroup& group) {
      const GateRow& first = assessment.gate[group.rows.front()].row;
      return first.candidate == row.candidate && first.quantity == row.quantity &&
             have_one_frame(group.frame, frame);
    });
    if (found == groups.end())
      groups.push_back({with_modes(frame, assessment.definition,
                                   assessment.runs.results.at(row.candidate).at(row.quantity)),
                        {i}});
    else
      found->rows.push_back(i);
  }
  return groups;
}

// "louder", "natural_1 gained", "natural_1 damped"
std::string full_name(const Mutation& mutation) {
  if (mutation.kind == MutationKind::mode_gained) return mutation.mode + " gained";
  if (mutation.kind == MutationKind::mode_damped) return mutation.mode + " damped";
  return mutation_name(mutation.kind);
}

}  // namespace

double datum_of(const CaseDefinition& definition, const std::string& quantity) {
  const Quantity* known = find_quantity(quantity);
  const std::string unit = known ? known->unit : "";
  const double depth = definition.liquid.fill_depth;
  if (unit == "Pa") return definition.liquid.density * definition.gravity * depth;
  return unit == "m" ? depth : 0;
}

void one_after_another(std::size_t count, const std::function<void(std::size_t)>& work) {
  for (std::size_t i = 0; i < count; ++i) work(i);
}

std::vector<RowSensitivity> gate_sensitivity(const CaseAssessment& assessment,
                                             SensitivityCache* cache,
                                             const ForEachIndex& for_each) {
  const std::string evidence = cache ? cache->evidence_of(assessment) : "";
  std::map<std::size_t, MutationTrials> by_row;
  std::vector<std::size_t> to_try, of_fields;
  for (std::size_t i = 0; i < assessment.gate.size(); ++i) {
    if (!can_be_mutated(assessment, assessment.gate[i])) continue;
    if (auto cached = cache ? cache->find(evidence, assessment.gate[i].row) : std::nullopt)
      by_row[i] = std::move(*cached);
    else if (is_of_fields(assessment.gate[i].row.metric))
      of_fields.push_back(i);
    else
      to_try.push_back(i);
  }
  const std::vector<RowGroup> groups = groups_of(assessment, to_try);
  std::vector<std::vector<MutationTrials>> found(groups.size());
  std::vector<MutationTrials> found_of_fields(of_fields.size());
  for_each(groups.size() + of_fields.size(), [&](std::size_t i) {
    if (i < groups.size())
      found[i] = trials_of(assessment, groups[i]);
    else
      found_of_fields[i - groups.size()] =
          try_field_mutations(assessment, assessment.gate[of_fields[i - groups.size()]]);
  });
  for (std::size_t k = 0; k < of_fields.size(); ++k)
    by_row[of_fields[k]] = std::move(found_of_fields[k]);
  for (std::size_t g = 0; g < groups.size(); ++g)
    for (std::size_t k = 0; k < groups[g].rows.size(); ++k)
      by_row[groups[g].rows[k]] = std::move(found[g][k]);
  std::vector<RowSensitivity> sensitivity;
  for (auto& [i, trials] : by_row) {
    if (cache) cache->keep(evidence, assessment.gate[i].row, trials);
    sensitivity.push_back({assessment.gate[i].row, std::move(trials)});
  }
  return sensitivity;
}

std::string short_row_name(const GateRow& row) {
  return fmt::format("{}, {} {} of {}", row.candidate, row.mode, measured_name(row), row.quantity);
}

std::vector<std::string> broken_claims(const std::vector<RowSensitivity>& sensitivity) {
  std::vector<std::string> broken;
  for (const auto& [row, trials] : sensitivity) {
    if (detects_no_change(trials))
      broken.push_back(short_row_name(row) + ": detects no change of its candidate's values");
    for (const Mutation& mutation : broken_claims(trials))
      broken.push_back(fmt::format("{}: {} {:.3g} should be detected and is not",
                                   short_row_name(row), full_name(mutation), mutation.strength));
  }
  return broken;
}

}  // namespace slosh

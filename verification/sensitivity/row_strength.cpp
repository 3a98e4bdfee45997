#include "verification/sensitivity/row_strength.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numbers>

#include "reports/model/side_by_side.hpp"
#include "verification/case/ensemble.hpp"
#include "verification/case/quantities.hpp"
#include "verification/evidence/case_evidence.hpp"
#include "verification/gate/impact_metrics.hpp"

namespace slosh {
namespace {

// Without the modes.
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

// The modes are left out where the window cannot tell them.
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

// What neither the candidate nor its mutants take part in.
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

std::vector<GateStrength> strengths_of(const CaseAssessment& assessment, const RowGroup& group) {
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
  const AskedOfModes asked = asked_by(judged);
  std::map<std::string, MutationFrame> frames;
  for (const std::string& run : members)
    frames[run] = run == candidate ? group.frame
                                   : with_modes(frame_of(assessment.definition, rows.front().row),
                                                assessment.definition, own(run));
  const JudgeRows judge = [&](const Mutation* mutation) {
    for (const std::string& run : members)
      series_of(runs.results.at(run), quantity) =
          mutation ? mutated(own(run), *mutation, frames.at(run)) : own(run);
    CaseEvidence evidence(assessment.definition, runs, &known, asked);
    std::vector<Verdict> verdicts;
    for (const TriedRow& one : rows) verdicts.push_back(evidence.judge(one.row).verdict);
    return verdicts;
  };
  return gate_strengths(rows, own(candidate), group.frame, judge);
}

bool can_be_mutated(const CaseAssessment& assessment, const GateOutcome& outcome) {
  return is_judged(outcome.verdict) &&
         has_series(assessment.runs, outcome.row.candidate, outcome.row.quantity);
}

bool have_one_frame(const MutationFrame& a, const MutationFrame& b) {
  return a.window.begin == b.window.begin && a.window.end == b.window.end && a.period == b.period;
}

// Of the rows with these numbers.
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

std::string row_text(const GateRow& row) {
  return fmt::format("{}, {} {} of {}", row.candidate, row.mode, measured_name(row), row.quantity);
}

constexpr std::pair<MutationKind, MutationKind> graded[] = {
    {MutationKind::louder, MutationKind::quieter},
    {MutationKind::late, MutationKind::early},
    {MutationKind::faster, MutationKind::slower},
    {MutationKind::raised, MutationKind::lowered},
    {MutationKind::drifting, MutationKind::drifting},
    {MutationKind::chirped, MutationKind::chirped},
    {MutationKind::mode_gained, MutationKind::mode_gained},
    {MutationKind::mode_damped, MutationKind::mode_damped},
    {MutationKind::noisy, MutationKind::noisy}};

constexpr MutationKind ungraded[] = {MutationKind::slipped,      MutationKind::truncated,
                                     MutationKind::not_a_number, MutationKind::swapped_columns,
                                     MutationKind::thousandfold, MutationKind::other_unit,
                                     MutationKind::sign_flipped};

// Both ways of a change must be detected: the weaker one counts.
std::string detected_text(const GateStrength& strength,
                          const std::pair<MutationKind, MutationKind>& ways) {
  const auto one = detected_from(strength, ways.first),
             other = detected_from(strength, ways.second);
  return one && other ? fmt::format("{:.3g}", 100 * std::max(*one, *other)) : "not detected";
}

std::string unnoticed(const GateStrength& strength) {
  std::vector<std::string> names;
  for (const MutationKind kind : ungraded)
    if (!detected_from(strength, kind)) names.push_back(mutation_name(kind));
  return names.empty() ? "nothing" : fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

double datum_of(const CaseDefinition& definition, const std::string& quantity) {
  const double depth = definition.liquid.fill_depth;
  if (quantity.starts_with("wall_pressure@"))
    return definition.liquid.density * definition.gravity * depth;
  const bool is_a_length = quantity == "front_position" || quantity.starts_with("elevation@") ||
                           quantity.starts_with("highest_surface@");
  return is_a_length ? depth : 0;
}

std::vector<RowStrength> row_strengths(const CaseAssessment& assessment, int threads,
                                       KnownStrengths* known) {
  const std::string evidence = known ? known->evidence_of(assessment) : "";
  std::map<std::size_t, GateStrength> by_row;
  std::vector<std::size_t> to_try;
  for (std::size_t i = 0; i < assessment.gate.size(); ++i) {
    if (!can_be_mutated(assessment, assessment.gate[i])) continue;
    if (auto strength = known ? known->find(evidence, assessment.gate[i].row) : std::nullopt)
      by_row[i] = std::move(*strength);
    else
      to_try.push_back(i);
  }
  const std::vector<RowGroup> groups = groups_of(assessment, to_try);
  std::vector<std::vector<GateStrength>> found(groups.size());
  reports::side_by_side(groups.size(), threads,
                        [&](std::size_t i) { found[i] = strengths_of(assessment, groups[i]); });
  for (std::size_t g = 0; g < groups.size(); ++g)
    for (std::size_t k = 0; k < groups[g].rows.size(); ++k)
      by_row[groups[g].rows[k]] = std::move(found[g][k]);
  std::vector<RowStrength> strengths;
  for (const auto& [i, strength] : by_row)
    if (known) known->keep(evidence, assessment.gate[i].row, strength);
  for (auto& [i, strength] : by_row)
    strengths.push_back({assessment.gate[i].row, std::move(strength)});
  return strengths;
}

reports::Table strength_table(const CaseAssessment& assessment,
                              const std::vector<RowStrength>& strengths) {
  reports::Table table{
      assessment.definition.name + "-strength",
      "What each gate row can detect",
      "The row's candidate made wrong on purpose, as far as the row passes with it as it is: the "
      "smallest change from which on every greater one that was tried is detected, of the "
      "amplitude (1 to 20 %), the lag (0.5 to 10 % of a period), the frequency (0.1 to 5 %), the "
      "datum (0.5 to 10 % of the fill depth, or of the pressure under it), a drift (10 to 100 % of "
      "the standard deviation over the window), a slow change of frequency (2 to 20 % of a period "
      "over the window), the gain of each natural mode (2 to 50 %), its decay (1.1 to 6 times as "
      "fast) and noise (1 to 50 % of the "
      "standard deviation), and what the row does not notice at all of a slip by a period, a "
      "series cut short, NaN, swapped columns, values or units off by a thousand, a flipped sign.",
      {"row", "amplitude [%]", "lag [% of a period]", "frequency [%]", "datum [%]", "drift [%]",
       "chirp [% of a period]", "natural modes [%]", "decay [%]", "noise [%]", "does not notice"},
      {}};
  for (const auto& [row, strength] : strengths) {
    std::vector<std::string> line{row_text(row)};
    if (strength.passes_as_it_is) {
      for (const auto& ways : graded) line.push_back(detected_text(strength, ways));
      line.push_back(unnoticed(strength));
    } else {
      line.resize(1 + std::size(graded));
      line.push_back("does not pass as it is");
    }
    table.rows.push_back(std::move(line));
  }
  return table;
}

std::vector<std::string> broken_claims(const std::vector<RowStrength>& strengths) {
  std::vector<std::string> broken;
  for (const auto& [row, strength] : strengths) {
    if (detects_no_change(strength))
      broken.push_back(row_text(row) + ": detects no change of its candidate's values");
    for (const Mutation& mutation : broken_claims(strength))
      broken.push_back(fmt::format(
          "{}: {} {:.3g} should be detected and is not", row_text(row),
          mutation.mode.empty() ? mutation_name(mutation.kind) : mutation.mode + " gained",
          mutation.strength));
  }
  return broken;
}

}  // namespace slosh

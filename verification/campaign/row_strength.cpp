#include "verification/campaign/row_strength.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <future>
#include <numbers>

#include "verification/campaign/case_evidence.hpp"
#include "verification/case_file/ensemble.hpp"

namespace slosh {
namespace {

MutationFrame frame_of(const CaseDefinition& definition, const GateRow& row) {
  const TimeWindow window{definition.window_begin, definition.window_end};
  const std::vector<ToneRequest> modes = fitted_modes(definition);
  if (modes.empty()) return {window, window.end - window.begin};
  const auto own = std::find_if(modes.begin(), modes.end(),
                                [&](const ToneRequest& mode) { return mode.name == row.mode; });
  const ToneRequest& mode = own == modes.end() ? modes.front() : *own;
  return {window, 2 * std::numbers::pi / mode.angular_frequency};
}

TimeSeries& series_of(RunResult& result, const std::string& quantity) {
  return *std::find_if(result.series.begin(), result.series.end(),
                       [&](const TimeSeries& one) { return one.name == quantity; });
}

GateStrength strength_of(const CaseAssessment& assessment, const GateOutcome& outcome) {
  const GateRow& row = outcome.row;
  CaseRuns runs{assessment.runs.status, {}, assessment.runs.timings, assessment.runs.input_bounds};
  for (const auto& [run, result] : assessment.runs.results)
    runs.results[run] = judged_part(result, row.quantity);
  const MutationFrame frame = frame_of(assessment.definition, row);
  const auto own = [&](const std::string& run) -> const TimeSeries& {
    return assessment.runs.results.at(run).at(row.quantity);
  };
  const PassesWith passes_with = [&](const Mutation* mutation) {
    for (const std::string& run : members_of(assessment.definition, row.candidate))
      series_of(runs.results.at(run), row.quantity) =
          mutation ? mutated(own(run), *mutation, frame) : own(run);
    return CaseEvidence(assessment.definition, runs).judge(row).verdict == Verdict::pass;
  };
  return gate_strength(row, {outcome.value.value, own(row.candidate)}, frame, passes_with);
}

bool is_judged(const CaseAssessment& assessment, const GateOutcome& outcome) {
  const bool judged = outcome.verdict == Verdict::pass || outcome.verdict == Verdict::violated ||
                      outcome.verdict == Verdict::inconclusive;
  return judged && has_series(assessment.runs, outcome.row.candidate, outcome.row.quantity);
}

std::string row_text(const GateRow& row) {
  return fmt::format("{}, {} {} of {}", row.candidate, row.mode, measured_name(row), row.quantity);
}

constexpr std::pair<MutationKind, MutationKind> graded[] = {
    {MutationKind::louder, MutationKind::quieter},
    {MutationKind::late, MutationKind::early},
    {MutationKind::faster, MutationKind::slower},
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
  return one && other ? fmt::format("{:.3g}", 100 * std::max(*one, *other)) : "none tried";
}

std::string unnoticed(const GateStrength& strength) {
  std::vector<std::string> names;
  for (const MutationKind kind : ungraded)
    if (!detected_from(strength, kind)) names.push_back(mutation_name(kind));
  return names.empty() ? "nothing" : fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

std::vector<RowStrength> row_strengths(const CaseAssessment& assessment, int threads) {
  std::vector<const GateOutcome*> judged;
  for (const GateOutcome& outcome : assessment.gate)
    if (is_judged(assessment, outcome)) judged.push_back(&outcome);
  std::vector<RowStrength> strengths(judged.size());
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i = next++; i < judged.size(); i = next++)
      strengths[i] = {judged[i]->row, strength_of(assessment, *judged[i])};
  };
  std::vector<std::future<void>> workers;
  for (int i = 0; i < threads; ++i) workers.push_back(std::async(std::launch::async, work));
  for (std::future<void>& worker : workers) worker.get();
  return strengths;
}

reports::Table strength_table(const CaseAssessment& assessment,
                              const std::vector<RowStrength>& strengths) {
  reports::Table table{
      assessment.definition.name + "-strength",
      "What each gate row can detect",
      "The row's candidate made wrong on purpose, as far as the row passes with it as it is: the "
      "smallest change from which on every greater one that was tried is detected, of the "
      "amplitude "
      "(1 to 20 %), the lag (0.5 to 10 % of a period), the frequency (0.1 to 5 %) and noise (1 to "
      "50 "
      "% of the standard deviation), and what the row does not notice at all of a slip by a "
      "period, "
      "a series cut short, NaN, swapped columns, values or units off by a thousand, a flipped "
      "sign.",
      {"row", "amplitude [%]", "lag [% of a period]", "frequency [%]", "noise [%]",
       "does not notice"},
      {}};
  for (const auto& [row, strength] : strengths) {
    std::vector<std::string> line{row_text(row)};
    if (strength.passes_as_it_is) {
      for (const auto& ways : graded) line.push_back(detected_text(strength, ways));
      line.push_back(unnoticed(strength));
    } else {
      line.insert(line.end(), {"", "", "", "", "does not pass as it is"});
    }
    table.rows.push_back(std::move(line));
  }
  return table;
}

std::vector<std::string> broken_claims(const std::vector<RowStrength>& strengths) {
  std::vector<std::string> broken;
  for (const auto& [row, strength] : strengths)
    for (const Mutation& mutation : broken_claims(strength))
      broken.push_back(fmt::format("{}: {} {:.3g} should be detected and is not", row_text(row),
                                   mutation_name(mutation.kind), mutation.strength));
  return broken;
}

}  // namespace slosh

#include "reports/summary/sensitivity_tables.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>

#include "reports/wording/report_places.hpp"

namespace slosh {
namespace {

constexpr std::pair<MutationKind, MutationKind> graded_kinds[] = {
    {MutationKind::louder, MutationKind::quieter},
    {MutationKind::late, MutationKind::early},
    {MutationKind::faster, MutationKind::slower},
    {MutationKind::raised, MutationKind::lowered},
    {MutationKind::drifting, MutationKind::drifting},
    {MutationKind::chirped, MutationKind::chirped},
    {MutationKind::mode_gained, MutationKind::mode_gained},
    {MutationKind::mode_damped, MutationKind::mode_damped},
    {MutationKind::noisy, MutationKind::noisy}};

constexpr MutationKind ungraded_kinds[] = {
    MutationKind::slipped,         MutationKind::truncated,    MutationKind::not_a_number,
    MutationKind::swapped_columns, MutationKind::thousandfold, MutationKind::other_unit,
    MutationKind::sign_flipped};

// A change must be detected both ways: the larger of the two strengths counts.
std::string detected_text(const MutationTrials& trials,
                          const std::pair<MutationKind, MutationKind>& ways) {
  const auto one = detected_from(trials, ways.first), other = detected_from(trials, ways.second);
  return one && other ? fmt::format("{:.3g}", 100 * std::max(*one, *other)) : "not detected";
}

std::string unnoticed(const MutationTrials& trials) {
  std::vector<std::string> names;
  for (const MutationKind kind : ungraded_kinds)
    if (was_tried(trials, kind) && !detected_from(trials, kind))
      names.push_back(mutation_name(kind));
  return names.empty() ? "nothing" : fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

reports::Table sensitivity_table(const CaseAssessment& assessment,
                                 const std::vector<RowSensitivity>& sensitivity) {
  reports::Table table{
      case_id(assessment.definition.name) + "-strength",
      "What each gate row can detect",
      "The row's candidate made wrong on purpose, as far as the row passes with it as it is: the "
      "smallest change from which on every greater one that was tried is detected, of the "
      "amplitude (1 to 20 %), the lag (0.5 to 10 % of a period), the frequency (0.1 to 5 %), the "
      "datum (0.5 to 10 % of the fill depth, or of the pressure under it), a drift (10 to 100 % of "
      "the standard deviation over the window), a slow change of frequency (2 to 20 % of a period "
      "over the window), the gain of each natural mode (2 to 50 %), its decay (1.1 to 6 times as "
      "fast) and noise (1 to 50 % of the "
      "standard deviation), and what the row does not notice at all of a slip by a period, a "
      "series cut short, NaN, swapped columns, values or units off by a thousand, a flipped sign. "
      "The lag of a pressure field is a distance along the tank, in % of its length; it has no "
      "frequency, drift, chirp and modes, and loses its last moments where a series is cut short.",
      {"row", "amplitude [%]", "lag [% of a period]", "frequency [%]", "datum [%]", "drift [%]",
       "chirp [% of a period]", "natural modes [%]", "decay [%]", "noise [%]", "does not notice"},
      {}};
  for (const auto& [row, trials] : sensitivity) {
    std::vector<std::string> line{short_row_name(row)};
    if (trials.passes_as_it_is) {
      for (const auto& ways : graded_kinds) line.push_back(detected_text(trials, ways));
      line.push_back(unnoticed(trials));
    } else {
      line.resize(1 + std::size(graded_kinds));
      line.push_back("does not pass as it is");
    }
    table.rows.push_back(std::move(line));
  }
  return table;
}

reports::Table coverage_table(const std::string& id, const std::vector<CaseCoverage>& cases) {
  reports::Table table{
      id,
      "What the rows of each case detect together",
      "Each candidate made wrong on purpose: values times 1.1, ten degrees late, off by 2 % of the "
      "fill depth (a pressure: of that under it), with white noise of 10 % of the standard "
      "deviation, cut short by a fifth of the window. Detected: at least one row of the case that "
      "passes as it is does not pass any more. Not applicable: nothing moves the liquid.",
      {"case", "rows judged", "rows declared"},
      {}};
  for (const RequiredDetection& one : required_detections) table.header.emplace_back(one.name);
  for (const CaseCoverage& one : cases) {
    std::vector<std::string> line{one.case_name, std::to_string(one.rows_judged),
                                  std::to_string(one.rows_declared)};
    for (const RequiredDetection& required : required_detections)
      line.push_back(coverage_name(one.detections.at(required.name).coverage));
    table.rows.push_back(std::move(line));
  }
  return table;
}

}  // namespace slosh

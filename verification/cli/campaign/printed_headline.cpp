#include "verification/cli/campaign/printed_headline.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "reports/summary/shown_rows.hpp"
#include "verification/assessment/row_kinds.hpp"
#include "verification/sensitivity/case_coverage.hpp"

namespace slosh {

std::string verdict_text(const AssessedCampaign& assessed, const std::vector<HeadlineLine>& lines,
                         int status) {
  const auto& [definition, output, cases, problems] = assessed;
  auto [lead, row, finding] = decision_of(cases, problems);
  if (status == exit_solver_failed) finding = "";  // the complaint about the run has it
  const std::string sentence =
      lines.empty() ? verdict_sentence(cases, problems) : headline_sentence(lines);
  std::string decision;
  if (!row.text.empty())
    decision = fmt::format(" {} {}{}", lead, row.text, finding.empty() ? "." : ": " + finding);
  // The line of a case without a reference is the row that decides: what remains is the remedy.
  const std::size_t remedy = finding.find(". What would decide it");
  const std::string told =
      finding.substr(0, std::min(remedy, finding.size() - finding.ends_with('.')));
  if (!told.empty() && sentence.find(told) != sentence.npos)
    decision = remedy == finding.npos ? "" : finding.substr(remedy + 1);
  return fmt::format("{}: {}{}", headline_word(status, lines), sentence, decision);
}

std::string headline_text(const AssessedCampaign& assessed, int status) {
  const auto& [definition, output, cases, problems] = assessed;
  const std::vector<HeadlineLine> lines = headline_lines(cases, problems);
  std::string text = verdict_text(assessed, lines, status);
  for (const CaseAssessment& one : cases)
    for (const std::string& doubt : one.doubts) text += "\n" + doubt;
  // Those of the only case stand in the sentence.
  const bool is_one = std::ranges::all_of(
      lines, [&](const HeadlineLine& line) { return line.name == lines.front().name; });
  for (const HeadlineLine& line : is_one ? std::vector<HeadlineLine>{} : lines)
    text += fmt::format("\n{:<22} {}: {}{}", line.standing, line.name, line_text(line),
                        has_numbers(line) ? "; decided by " + line.decides : "");
  return text;
}

std::string rows_text(const AssessedCampaign& assessed) {
  const auto& [definition, output, cases, problems] = assessed;
  const std::string basis = basis_sentence(cases, problems);
  return verdict_sentence(cases, problems) + coverage_sentence(cases) +
         (basis.empty() ? "" : " " + basis);
}

}  // namespace slosh

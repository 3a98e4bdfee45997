#include "verification/cli/campaign/printed_headline.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "reports/summary/headline.hpp"
#include "reports/summary/worst_first.hpp"
#include "verification/assessment/row_kinds.hpp"
#include "verification/evidence/soundness.hpp"
#include "verification/sensitivity/case_coverage.hpp"

namespace slosh {

std::string verdict_text(const AssessedCampaign& assessed, int status) {
  const auto& [definition, output, cases, problems] = assessed;
  auto [lead, row, finding] = decision_of(cases, problems);
  if (status == exit_solver_failed) finding = "";  // the complaint about the run has it
  const std::string sentence = headline_sentence(cases, problems);
  std::string decision;
  if (!row.text.empty())
    decision = fmt::format(" {} {}{}", lead, row.text, finding.empty() ? "." : ": " + finding);
  // The line of a case without a reference is the row that decides: what remains is the remedy.
  const std::size_t remedy = finding.find(". What would decide it");
  const std::string told =
      finding.substr(0, std::min(remedy, finding.size() - finding.ends_with('.')));
  if (!told.empty() && sentence.find(told) != sentence.npos)
    decision = remedy == finding.npos ? "" : finding.substr(remedy + 1);
  return fmt::format("{}: {}{}", headline_word(status, cases, problems), sentence, decision);
}

std::string headline_text(const AssessedCampaign& assessed, int status) {
  const auto& [definition, output, cases, problems] = assessed;
  std::string text = verdict_text(assessed, status);
  for (const CaseAssessment& one : cases)
    if (const std::string doubt = doubtful_runs(one.definition, one.runs); !doubt.empty())
      text += "\n" + doubt;
  for (const HeadlineLine& line : headline_lines(cases, problems))
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

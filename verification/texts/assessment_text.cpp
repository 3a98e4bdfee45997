#include "verification/texts/assessment_text.hpp"

#include <fmt/format.h>

#include <sstream>

#include "verification/case/campaign_definition.hpp"

namespace slosh {
namespace {

// Returns the last lines of the failed program's output, and the place of the whole log.
std::string words_of(const RunStatus& status) {
  if (!status.failure) return "";
  std::string text;
  std::istringstream lines(status.failure->details);
  for (std::string line; std::getline(lines, line);) text += "    " + line + "\n";
  if (!status.failure->log.empty()) text += "    log: " + status.failure->log + "\n";
  return text;
}

// Returns "" for a run or a problem of which nothing is missing.
std::string complaint(const std::string& name, const RunStatus& status) {
  if (status.state != RunState::failed && status.state != RunState::missing &&
      status.state != RunState::not_supplied)
    return "";
  return fmt::format("{}: {}: {}\n{}", name, state_name(status.state), status.message,
                     words_of(status));
}

}  // namespace

std::string complaints(const std::vector<CaseAssessment>& cases,
                       const std::vector<ProblemAssessment>& problems) {
  std::string text;
  for (const CaseAssessment& one : cases)
    for (const auto& [run, status] : one.runs.status)
      text += complaint(one.definition.name + "/" + run, status);
  for (const ProblemAssessment& one : problems)
    text += complaint(one.definition.name, one.run.status);
  return text;
}

std::string gate_lines(const std::vector<CaseAssessment>& cases,
                       const std::vector<ProblemAssessment>& problems) {
  std::string text;
  for (const CaseAssessment& one : cases)
    for (const GateOutcome& outcome : one.gate) {
      if (outcome.verdict == Verdict::not_selected) continue;
      text += fmt::format("{:<14} {} {} {} {} {}: {}\n", verdict_name(outcome.verdict),
                          one.definition.name, outcome.row.candidate, outcome.row.mode,
                          measured_name(outcome.row), outcome.row.quantity, outcome.message);
    }
  for (const ProblemAssessment& one : problems)
    for (const ProblemGateOutcome& outcome : one.gate) {
      if (outcome.verdict == Verdict::not_selected) continue;
      text +=
          fmt::format("{:<14} {} {} {}: {}\n", verdict_name(outcome.verdict), one.definition.name,
                      metric_name(outcome.row.metric), outcome.row.measure, outcome.message);
    }
  return text;
}

}  // namespace slosh

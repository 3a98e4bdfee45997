#include "verification/assessment_text.hpp"

#include <fmt/format.h>

#include "verification/case_file/problem_table.hpp"

namespace slosh {

std::string complaints(const std::vector<CaseAssessment>& cases,
                       const std::vector<ProblemAssessment>& problems) {
  std::string text;
  for (const CaseAssessment& one : cases)
    for (const auto& [run, status] : one.runs.status)
      if (status.state == RunState::failed || status.state == RunState::missing ||
          status.state == RunState::not_supplied)
        text += fmt::format("{}/{}: {}: {}\n", one.definition.name, run, state_name(status.state),
                            status.message);
  for (const ProblemAssessment& one : problems)
    if (!one.run.result && one.run.status.state != RunState::not_selected)
      text += fmt::format("{}: {}: {}\n", one.definition.name, state_name(one.run.status.state),
                          one.run.status.message);
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

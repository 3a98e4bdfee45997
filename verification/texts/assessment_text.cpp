#include "verification/texts/assessment_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <utility>
#include <vector>

#include "verification/case/campaign_definition.hpp"
#include "verification/gate/gate.hpp"

namespace slosh {
namespace {

// Returns the words with which a line of a verdict may begin, and their colours.
std::vector<std::pair<std::string, const char*>> coloured_words() {
  return {{verdict_name(Verdict::pass), green},
          {verdict_name(Verdict::violated), red},
          {verdict_name(Verdict::solver_failed), red},
          {verdict_name(Verdict::inconclusive), yellow},
          {verdict_name(Verdict::not_compared), yellow},
          {headline_word(exit_pass), green},
          {headline_word(exit_violated), red},
          {headline_word(exit_inconclusive), yellow},
          {headline_word(exit_not_compared), yellow},
          {"validated", green},
          {"limits kept", green},
          {"watched, not validated", blue},
          {"WATCHED, NOT VALIDATED", blue}};
}

std::string coloured(const std::string& line) {
  for (const auto& [word, colour] : coloured_words()) {
    const bool ends =
        line.size() > word.size() && (line[word.size()] == ' ' || line[word.size()] == ':');
    if (line.starts_with(word) && ends) return colour + word + normal + line.substr(word.size());
  }
  return line;
}

std::string broken(std::string line, std::size_t columns) {
  const std::string indent(std::min<std::size_t>(columns / 8, 4), ' ');
  std::string lines;
  std::size_t begin = 0;  // of the first word in the line
  while (line.size() > columns) {
    std::size_t at = line.rfind(' ', columns);
    if (at == std::string::npos || at <= begin)
      at = line.find(' ', begin);  // a word longer than the line
    if (at == std::string::npos) break;
    lines += line.substr(0, at) + '\n';
    line = indent + line.substr(at + 1);
    begin = indent.size();
  }
  return lines + line;
}

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

std::string as_shown(const std::string& text, const DisplayStyle& style) {
  if (!style.live) return text;
  std::string shown;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    line = broken(line, static_cast<std::size_t>(std::max(style.columns, 1)));
    shown += (style.colour ? coloured(line) : line) + '\n';
  }
  return shown;
}

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

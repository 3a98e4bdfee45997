#include "verification/cli/texts/campaign_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <sstream>
#include <utility>
#include <vector>

#include "verification/campaign/campaign_plan.hpp"
#include "verification/case/campaign_definition.hpp"
#include "verification/files/shell_word.hpp"
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

// Quotes a word that a shell would split or expand.
std::string shown(const std::string& word) {
  constexpr const char* plain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./=,:+@%";
  if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) return word;
  return shell_word(word);
}

std::string command_text(const Job& job) {
  std::vector<std::string> words;
  for (const std::string& word : job.command) words.push_back(shown(word));
  return fmt::format("{}", fmt::join(words, " "));
}

struct Sums {
  int kept = 0, left_out = 0, to_run = 0, timings = 0, unknown = 0;
  double processor_time = 0, alone = 0;  // [s]
  bool measured = true;                  // all of known cost, by earlier runs with the same key
  std::map<std::string, std::string> names = {};  // by key, of the first run that has it
};

std::string line_of(const Job& job, const std::string& cost, Sums& sums) {
  (job.alone ? sums.alone : sums.processor_time) += job.expected_time * job.cores;
  return fmt::format("{:<8} {} ({})\n         {}\n", job.alone ? "time" : "run", job.name, cost,
                     command_text(job));
}

// For a problem and for a timing.
std::string line_of(const Job& job, Sums& sums) {
  const double cost = job.expected_time * job.cores;
  return line_of(
      job, cost > 0 ? fmt::format("about {:.3g} core-seconds", cost) : "core-seconds not known",
      sums);
}

std::string line_of(const PlannedRun& planned, const CampaignSettings& settings, Sums& sums) {
  const std::string name = planned.definition->name + "/" + planned.run->name;
  const auto [first, is_new] = sums.names.try_emplace(planned.key, name);
  if (planned.status.state == RunState::finished || (is_pending(planned) && !is_new)) {
    ++sums.kept;
    return fmt::format("kept     {}{}\n", name,
                       is_pending(planned) ? ", which is " + first->second : "");
  }
  if (!is_pending(planned)) {
    ++sums.left_out;
    return "";
  }
  ++sums.to_run;
  const ExpectedCost cost =
      expected_cost(*planned.definition, *planned.run, planned.key, settings.store);
  if (!cost.known()) ++sums.unknown;
  if (cost.known() && !cost.measured) sums.measured = false;
  return line_of(job_for(planned, settings), cost_text(cost), sums);
}

std::string sums_text(const Sums& sums, const CampaignSettings& settings) {
  std::string text =
      fmt::format("{} kept, {} to run, {} left out", sums.kept, sums.to_run, sums.left_out);
  if (sums.to_run > sums.unknown)
    text +=
        fmt::format("; about {:.3g} core-seconds ({}), {:.2g} min on {} cores", sums.processor_time,
                    sums.measured ? "as such runs took before" : "in part scaled from other runs",
                    sums.processor_time / 60 / settings.at_once, settings.at_once);
  if (sums.unknown > 0) text += fmt::format("; {} of unknown cost, not counted", sums.unknown);
  if (sums.timings > 0)
    text +=
        fmt::format("; {} timings one after another, {:.2g} min", sums.timings, sums.alone / 60);
  return text + "\nstore: " + settings.store.root().string() + "\n";
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

std::string plan_text(const std::vector<CaseDefinition>& cases,
                      const std::vector<ProblemDefinition>& problems,
                      const CampaignSettings& settings) {
  Sums sums;
  std::string text, timings;
  for (const ProblemDefinition& problem : problems) {
    const ProblemRun standing = standing_problem(problem, settings);
    if (standing.result) text += fmt::format("kept     {}\n", problem.name);
    const bool pending = standing.status.state == RunState::missing;
    if (pending) text += line_of(job_for(problem, settings), sums);
    ++(standing.result ? sums.kept : pending ? sums.to_run : sums.left_out);
  }
  for (const PlannedRun& planned : plan_runs(cases, settings)) {
    const bool is_shared = sums.names.contains(planned.key);
    text += line_of(planned, settings, sums);
    if (is_shared) continue;
    for (const Job& job : timing_jobs(planned, settings)) {
      ++sums.timings;
      timings += line_of(job, sums);
    }
  }
  return text + timings + sums_text(sums, settings);
}

}  // namespace slosh

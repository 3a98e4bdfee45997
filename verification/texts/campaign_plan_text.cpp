#include "verification/texts/campaign_plan_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>

#include "verification/campaign/campaign_plan.hpp"
#include "verification/files/shell_word.hpp"

namespace slosh {
namespace {

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

#include "verification/assessment/campaign_cost.hpp"

#include <fmt/format.h>

#include <set>

#include "verification/case/solver_kinds.hpp"

namespace slosh {
namespace {

std::string duration_text(double seconds) {
  if (seconds >= 3600) return fmt::format("{:.1f} hours", seconds / 3600);
  return fmt::format("{:.1f} minutes", seconds / 60);
}

}  // namespace

CampaignCost campaign_cost(const std::vector<CaseAssessment>& cases,
                           const std::vector<ProblemAssessment>& problems) {
  CampaignCost all;
  std::set<std::string> counted;  // the keys: two cases may share a run
  const auto add = [&](const auto& result) {
    if (!counted.insert(result.key).second) return;
    ++all.results;
    all.core_seconds += result.cost.core_seconds();
  };
  for (const CaseAssessment& one : cases) {
    for (const RunDefinition& run : one.definition.runs)
      if (const auto result = one.runs.results.find(run.name);
          result != one.runs.results.end() && !is_stored(run) && !is_record(run))
        add(result->second);
    for (const auto& [input, bounds] : one.runs.input_bounds)
      for (const RunResult* bound : {&bounds.lower, &bounds.upper})
        if (!bound->key.empty()) add(*bound);  // a run's, and not the prediction of a theory
  }
  for (const ProblemAssessment& one : problems)
    if (one.run.result) add(*one.run.result);
  return all;
}

std::string cost_sentence(const std::vector<CaseAssessment>& cases,
                          const std::vector<ProblemAssessment>& problems) {
  const CampaignCost all = campaign_cost(cases, problems);
  if (all.results == 0) return "";
  return fmt::format(
      "The results of the campaign cost {:.{}f} core-seconds ({}). This is the sum over its runs "
      "and "
      "problems, {} in all, each measured when it was made.",
      all.core_seconds, all.core_seconds < 100 ? 1 : 0, duration_text(all.core_seconds),
      all.results);
}

}  // namespace slosh

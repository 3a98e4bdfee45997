#include "verification/assessment/campaign_cost.hpp"

#include <fmt/format.h>

#include "verification/evidence/run_cost.hpp"

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
  const auto add = [&](const RunCost& cost) {
    ++all.results;
    all.core_seconds += cost.core_seconds();
  };
  for (const CaseAssessment& one : cases)
    for (const auto& [run, result] : one.runs.results)
      if (!cost_of(one.runs, run).elsewhere) add(result.cost);
  for (const ProblemAssessment& one : problems)
    if (one.run.result) add(one.run.result->cost);
  return all;
}

std::string cost_sentence(const std::vector<CaseAssessment>& cases,
                          const std::vector<ProblemAssessment>& problems) {
  const CampaignCost all = campaign_cost(cases, problems);
  if (all.results == 0) return "";
  return fmt::format(
      "The campaign cost {:.{}f} core-seconds ({}): the sum over {} {}, each measured when it was "
      "made.",
      all.core_seconds, all.core_seconds < 100 ? 1 : 0, duration_text(all.core_seconds),
      all.results, all.results == 1 ? "result" : "results");
}

}  // namespace slosh

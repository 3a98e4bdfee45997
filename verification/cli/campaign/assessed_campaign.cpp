#include "verification/cli/campaign/assessed_campaign.hpp"

#include <unistd.h>

#include <iostream>
#include <stdexcept>
#include <utility>

#include "reports/model/side_by_side.hpp"
#include "sph/threads.hpp"
#include "verification/campaign/campaign_run.hpp"
#include "verification/texts/verdict_text.hpp"

namespace slosh {

namespace {

// A row whose record is not in the directory that the user named was to be judged.
void miss_records(CaseAssessment& assessment) {
  for (GateOutcome& outcome : assessment.gate)
    if (outcome.verdict == Verdict::not_supplied) outcome.verdict = Verdict::not_compared;
}

}  // namespace

AssessedCampaign assess(RequestedCampaign campaign, const std::atomic<bool>& stop) {
  CampaignRuns runs =
      run_campaign_jobs(campaign.cases, campaign.definition.problems, campaign.settings, stop);
  AssessedCampaign assessed{std::move(campaign.definition), campaign.place, {}, {}};
  assessed.cases.resize(campaign.cases.size());
  reports::side_by_side(campaign.cases.size(), sph::usable_cores(), [&](std::size_t i) {
    assessed.cases[i] = assess(campaign.cases[i], std::move(runs.cases[i]));
    if (!campaign.settings.experiments.empty()) miss_records(assessed.cases[i]);
  });
  for (std::size_t i = 0; i < runs.problems.size(); ++i)
    assessed.problems.push_back(
        assess(assessed.definition.problems[i], std::move(runs.problems[i])));
  return assessed;
}

AssessedCampaign assess_present(CampaignOptions options, const Installation& installation) {
  options.solve = false;
  const std::atomic<bool> never{false};
  return assess(requested(options, installation), never);
}

void print_lines(const std::string& text) {
  std::cout << as_shown(text, style_of(STDOUT_FILENO));
  if (!std::cout.flush()) throw std::runtime_error(not_printed);
}

int requested_exit(int status, const CampaignOptions& options) {
  return status == exit_inconclusive ? options.inconclusive_exit : status;
}

}  // namespace slosh

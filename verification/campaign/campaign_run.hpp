// Runs what a campaign's cases and problems declare, each a process of its own, and keeps every
// finished result under its key: one that stands is not computed again, whichever campaign asked
// for it.
#pragma once

#include <atomic>
#include <stdexcept>
#include <vector>

#include "verification/assessment/problem_assessment.hpp"
#include "verification/campaign/campaign_settings.hpp"
#include "verification/case/campaign_definition.hpp"
#include "verification/evidence/case_runs.hpp"

namespace slosh {

struct InterruptedError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct CampaignRuns {
  std::vector<CaseRuns> cases;  // in the order given, as the next
  std::vector<ProblemRun> problems;
};

// Computes what does not stand (nothing where settings.solve is false) and tells of it on standard
// error. Throws InterruptedError once `stop` is set, and CaseFileError where a run refused its
// case; what was finished stays.
CampaignRuns run_campaign_jobs(const std::vector<CaseDefinition>& cases,
                               const std::vector<ProblemDefinition>& problems,
                               const CampaignSettings& settings, const std::atomic<bool>& stop);

}  // namespace slosh

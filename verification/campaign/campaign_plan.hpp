// What a campaign asks for, what of that stands, and the jobs that are left.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "verification/campaign/campaign_settings.hpp"
#include "verification/engine/job.hpp"
#include "verification/evidence/case_runs.hpp"
#include "verification/runs/expected_cost.hpp"

namespace slosh {

struct PlannedRun {
  const CaseDefinition* definition;
  const RunDefinition* run;
  std::string key;
  RunStatus status;  // finished: its result stands (see StandingResult), else why it does not
  std::filesystem::path file;  // of the result that stands, or that a run would leave
};

// In the order of the cases and their runs. The cases outlive the plan.
std::vector<PlannedRun> plan_runs(const std::vector<CaseDefinition>& cases,
                                  const CampaignSettings& settings);

// A result that a campaign may take: that of the very key, or, where nothing is to be computed, the
// newest that answers the same question by another build.
struct StandingResult {
  std::filesystem::path file;
  std::string message;  // empty, or that it is another build's
};

// Throws ResultError where there is none. Only looks for the file.
StandingResult standing_result(const std::string& key, const char* extension,
                               const CampaignSettings& settings);

// To be computed: of runs that this machine can compute and whose result does not stand.
bool is_pending(const PlannedRun& planned);

// The run, and the repeats of it for its timings.
Job job_for(const PlannedRun& planned, const CampaignSettings& settings);
std::vector<Job> timing_jobs(const PlannedRun& planned, const CampaignSettings& settings);

// A link to the result, in the directories that it needs: what a campaign took is seen by its name.
void show_result(const std::filesystem::path& result, const std::filesystem::path& link);

// Where the campaign's own directory shows a run's result: a link into the store.
std::filesystem::path link_to_result(const CampaignSettings& settings,
                                     const CaseDefinition& definition, const RunDefinition& run);

}  // namespace slosh

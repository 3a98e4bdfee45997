// The runs of a campaign, which of their results are stored already, and the jobs for the others.
//
// Why the job of a run or a problem failed: from the failure file in the store, or else from the
// end of its process and its log; and what it waits for, from its log.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "verification/assessment/problem_assessment.hpp"
#include "verification/campaign/campaign_settings.hpp"
#include "verification/engine/job.hpp"
#include "verification/evidence/case_runs.hpp"
#include "verification/gate/gate.hpp"
#include "verification/runs/expected_cost.hpp"

namespace slosh {

// Returns the failure with texts that can be shown: a program's words command no terminal and break
// no document.
RunFailure legible(const RunFailure& failure);

// Returns the first line of the tool's message in a job's log, or else the log's last line.
std::string first_error_line(const std::filesystem::path& log);

// Returns what the job says that it waits for (file_lock.hpp); "" where it does not.
std::string awaited(const Job& job);

// Returns the status of a job that did not succeed. The result of a job that never started, or
// whose result could not be stored, is missing. A run whose solver failed has written the reason to
// `failure_file` (run_failure.hpp); for any other end the reason is written there now, if possible.
RunStatus status_without_result(const JobState& state, const std::filesystem::path& failure_file);

// The verification problems of a campaign, each solved in a process of its own: their stored
// results, the jobs for the others, and the outcome of these jobs.

std::string key_of(const ProblemDefinition& problem, const CampaignSettings& settings);

// Returns the problem with its stored result, or with the reason why there is none.
ProblemRun standing_problem(const ProblemDefinition& problem, const CampaignSettings& settings);

Job job_for(const ProblemDefinition& problem, const CampaignSettings& settings);

ProblemRun ended_problem(const JobState& state, const ProblemDefinition& problem,
                         const CampaignSettings& settings);

struct PlannedRun {
  const CaseDefinition* definition;
  const RunDefinition* run;
  std::string key;
  RunStatus status;  // finished: its result is usable (see StandingResult), else why it is not
  std::filesystem::path file;  // of the usable result, or of the one that a run would write
};

// Returns the runs in the order of the cases. The cases must outlive the plan.
std::vector<PlannedRun> plan_runs(const std::vector<CaseDefinition>& cases,
                                  const CampaignSettings& settings);

// What the store holds for a key: a failure under the key outranks every result. Else it is the
// result of the same key or, where nothing is to be computed, the newest result of the same
// question by another build.
struct StandingResult {
  std::filesystem::path file;  // of the usable result, or of the one that a run would write
  // finished, with an empty message or that it is another build's; failed, where nothing is to be
  // computed; or missing
  RunStatus status;
};

// Looks for the files and reads the failure alone.
StandingResult standing_result(const std::string& key, const char* extension,
                               const CampaignSettings& settings);

// Returns whether the run is to be computed: this machine can compute it and no result is usable.
bool is_pending(const PlannedRun& planned);

// Returns the job of the run, and the jobs of its repeats for timings.
Job job_for(const PlannedRun& planned, const CampaignSettings& settings);
std::vector<Job> timing_jobs(const PlannedRun& planned, const CampaignSettings& settings);

// Makes a link to the result, and the directories for it, so that results are found by their names.
// Replaces an earlier link to a result. Keeps anything else there, and says so on standard error.
void show_result(const std::filesystem::path& result, const std::filesystem::path& link);

// Removes the link to an earlier result of what has failed. Keeps what no campaign has made. Throws
// as require_own() (own_files.hpp).
void hide_result(const std::filesystem::path& link);

// Returns the place of a run's link in the campaign's directory.
std::filesystem::path link_to_result(const CampaignSettings& settings,
                                     const CaseDefinition& definition, const RunDefinition& run);

}  // namespace slosh

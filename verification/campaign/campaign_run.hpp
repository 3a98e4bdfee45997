// Runs the cases and problems of a campaign, each run in a process of its own, and stores every
// finished result under its key. A stored result is not computed again, whichever campaign made it.
// Programs of the user's come last: all other results are then read, and are none of what such a
// program may leave in the store.
#pragma once

#include <atomic>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <vector>

#include "verification/assessment/problem_assessment.hpp"
#include "verification/campaign/campaign_settings.hpp"
#include "verification/case/campaign_definition.hpp"
#include "verification/evidence/case_runs.hpp"
#include "verification/files/file_lock.hpp"

namespace slosh {

struct InterruptedError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct CampaignRuns {
  std::vector<CaseRuns> cases;  // in the order given, as the problems
  std::vector<ProblemRun> problems;
};

// Takes the lock of an output; says on standard error that it waits for another start. Throws
// InterruptedError once `stop` is set, and as require_own() (files/own_files.hpp).
std::unique_ptr<FileLock> lock_output(const std::filesystem::path& output,
                                      const std::atomic<bool>& stop);

// The same without waiting: null where another start works there.
std::unique_ptr<FileLock> free_output(const std::filesystem::path& output);

// Computes the missing results in a locked output (none where settings.solve is false) and shows
// the progress on standard error. Throws InterruptedError once `stop` is set, CaseFileError where a
// run refused its case, and ResultError where a program of the user's has changed a stored result
// (such a result is removed); finished results are kept.
CampaignRuns run_campaign_jobs(const std::vector<CaseDefinition>& cases,
                               const std::vector<ProblemDefinition>& problems,
                               const CampaignSettings& settings, const std::atomic<bool>& stop);

}  // namespace slosh

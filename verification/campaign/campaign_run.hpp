// Runs what a campaign's cases declare, each run a process of its own, and keeps every finished
// result: one whose key still fits is not computed again.
#pragma once

#include <atomic>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "verification/campaign/case_assessment.hpp"
#include "verification/campaign/run_selection.hpp"
#include "verification/case_file/campaign_definition.hpp"
#include "verification/runs/run_pool.hpp"

namespace slosh {

struct CampaignSettings {
  std::filesystem::path output;         // <output>/runs/<case>/<run>.h5, .log and work directories
  std::filesystem::path executable;     // this tool, which runs one run as `slosh run`
  std::filesystem::path solver_build;   // as run_key() takes it
  std::filesystem::path problem_build;  // as problem_key() takes it
  std::filesystem::path openfoam_templates;  // openfoam_cases/sloshing_tank
  std::filesystem::path experiments;         // of the user's records; empty: none is named
  RunSelection selection = {};               // what is run and judged; the rest is not selected
  bool solve = true;                         // false: only read what is there
  int at_once = 1;                           // processes
};

struct InterruptedError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// A result that is there, and the key that one made now would have.
struct KeptResult {
  std::filesystem::path file;
  std::string key, expected_key;
};

// "made by another build or version" of what may be read but not kept. Throws ResultError where the
// key does not fit: what was asked must be the same ("<file> was made for another <asked>"), and
// while there is a solver to ask again (settings.solve) the build must be this one too.
RunStatus status_of(const KeptResult& kept, const std::string& asked,
                    const CampaignSettings& settings);

// All of them side by side, told of on standard error; `what` they are, "runs". Throws
// InterruptedError once `stop` is set.
std::vector<JobState> run_jobs(const std::vector<Job>& jobs, const std::string& what,
                               const CampaignSettings& settings, const std::atomic<bool>& stop);

// Why a run failed, in its own words: the first line of the tool's message, or else the last line
// that it wrote.
std::string complaint_in(const std::filesystem::path& log);

// By case, in the order given. Throws InterruptedError once `stop` is set, and CaseFileError where
// a run refused its case; what was finished stays.
std::vector<CaseRuns> run_cases(const std::vector<CaseDefinition>& cases,
                                const CampaignSettings& settings, const std::atomic<bool>& stop);

// Where a run's result lies.
std::filesystem::path result_file(const CampaignSettings& settings,
                                  const CaseDefinition& definition, const RunDefinition& run);

}  // namespace slosh

// Runs the verification problems of a campaign, each a process of its own, and keeps every finished
// result: one whose key still fits is not computed again.
#pragma once

#include <atomic>
#include <filesystem>
#include <vector>

#include "verification/campaign/campaign_run.hpp"
#include "verification/campaign/problem_assessment.hpp"

namespace slosh {

// In the order given. Throws InterruptedError once `stop` is set; what was finished stays.
std::vector<ProblemRun> run_problems(const std::vector<ProblemDefinition>& problems,
                                     const CampaignSettings& settings,
                                     const std::atomic<bool>& stop);

// Where a problem's result lies.
std::filesystem::path problem_file(const CampaignSettings& settings,
                                   const ProblemDefinition& problem);

}  // namespace slosh

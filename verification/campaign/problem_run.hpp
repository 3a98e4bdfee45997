// The verification problems of a campaign, each solved in a process of its own: their stored
// results, the jobs for the others, and the outcome of these jobs.
#pragma once

#include <string>

#include "verification/assessment/problem_assessment.hpp"
#include "verification/campaign/campaign_settings.hpp"
#include "verification/engine/job.hpp"

namespace slosh {

std::string key_of(const ProblemDefinition& problem, const CampaignSettings& settings);

// Returns the problem with its stored result, or with the reason why there is none.
ProblemRun standing_problem(const ProblemDefinition& problem, const CampaignSettings& settings);

Job job_for(const ProblemDefinition& problem, const CampaignSettings& settings);

ProblemRun ended_problem(const JobState& state, const ProblemDefinition& problem,
                         const CampaignSettings& settings);

}  // namespace slosh

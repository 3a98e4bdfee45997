// The verification problems of a campaign, each a process of its own: what of them stands, the jobs
// that are left, and how those have ended.
#pragma once

#include <string>

#include "verification/assessment/problem_assessment.hpp"
#include "verification/campaign/campaign_settings.hpp"
#include "verification/engine/job.hpp"

namespace slosh {

std::string key_of(const ProblemDefinition& problem, const CampaignSettings& settings);

// That of the result that stands, or why none does.
ProblemRun standing_problem(const ProblemDefinition& problem, const CampaignSettings& settings);

Job job_for(const ProblemDefinition& problem, const CampaignSettings& settings);

ProblemRun ended_problem(const JobState& state, const ProblemDefinition& problem,
                         const CampaignSettings& settings);

}  // namespace slosh

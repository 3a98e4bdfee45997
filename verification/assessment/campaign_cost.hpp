// What the runs and problems of a campaign cost together.
#pragma once

#include <string>
#include <vector>

#include "verification/assessment/case_assessment.hpp"
#include "verification/assessment/problem_assessment.hpp"

namespace slosh {

struct CampaignCost {
  // Of runs and problems, a run that two cases share once; records and the stored results of other
  // codes do not count.
  std::size_t results = 0;
  double core_seconds = 0;  // [s] user and system time of all processes
};

// The cost of each run is that of the campaign's own run, measured when it was made. The runs at
// the bounds of the inputs count, timings do not.
CampaignCost campaign_cost(const std::vector<CaseAssessment>& cases,
                           const std::vector<ProblemAssessment>& problems);

// "The results of the campaign cost 10608 core-seconds (2.9 hours). This is the sum over its runs
// and problems, 153 in all, each measured when it was made.", or "" where nothing left a result.
std::string cost_sentence(const std::vector<CaseAssessment>& cases,
                          const std::vector<ProblemAssessment>& problems);

}  // namespace slosh

// A campaign with the results of its runs, compared and judged, and how the subcommands report it.
#pragma once

#include <atomic>
#include <filesystem>
#include <string>
#include <vector>

#include "verification/assessment/case_assessment.hpp"
#include "verification/assessment/problem_assessment.hpp"
#include "verification/case/campaign_definition.hpp"
#include "verification/cli/campaign/campaign_options.hpp"
#include "verification/cli/campaign/requested_campaign.hpp"

namespace slosh {

struct AssessedCampaign {
  CampaignDefinition definition;
  // The directory of the report and the gate's files: <options.output>, or for a selection its
  // folder selected/, so that a part is never mistaken for the whole.
  std::filesystem::path output;
  std::vector<CaseAssessment> cases;
  std::vector<ProblemAssessment> problems;
};

// Runs what is missing, if the settings ask for it, then compares and judges.
AssessedCampaign assess(RequestedCampaign campaign, const std::atomic<bool>& stop);

// Compares and judges the existing results. Starts no solver.
AssessedCampaign assess_present(CampaignOptions options, const Installation& installation);

// Prints on standard output, coloured and broken into lines if that is a terminal. Throws
// std::runtime_error where it cannot: no document says more than the exit status does.
void print_lines(const std::string& text);

// Returns the exit status, with the user's own in place of exit_inconclusive.
int requested_exit(int status, const CampaignOptions& options);

}  // namespace slosh

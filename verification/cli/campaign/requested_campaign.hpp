// A campaign as the options request it, with its files read and checked.
#pragma once

#include <atomic>
#include <filesystem>
#include <string>
#include <vector>

#include "verification/assessment/case_assessment.hpp"
#include "verification/assessment/problem_assessment.hpp"
#include "verification/campaign/campaign_settings.hpp"
#include "verification/case/campaign_definition.hpp"
#include "verification/cli/campaign/campaign_options.hpp"

namespace slosh {

struct RequestedCampaign {
  CampaignDefinition definition;
  std::vector<CaseDefinition> cases;  // with the runs of the campaign's sweeps
  CampaignSettings settings;
  // The directory of the report and the gate's files: the settings' output, or for a selection its
  // folder selected/, so that a part is never mistaken for the whole.
  std::filesystem::path place;
};

// Throws CaseFileError with all mistakes of the campaign and its cases, before anything runs.
RequestedCampaign requested(const CampaignOptions& options, const Installation& installation);

// Finds the mistakes that are left in cases once they are read, before anything runs: a window that
// is too short, and runs that their solver does not take. Throws CaseFileErrors with all of them.
// This takes seconds, as it sets up the start of every SPH run.
void require_runnable(const std::vector<CaseDefinition>& cases);

// Returns the suffix of the campaign's name in paths: "-quick" or none.
std::string form_of(const CampaignOptions& options);

// Returns the directory of the report and the gate's files (RequestedCampaign::place). It reads the
// campaign's file where the options name no output. Throws CaseFileError.
std::filesystem::path place_of(const CampaignOptions& options, const Installation& installation);

// Returns the directory of the campaign's ledgers and records: that of the installation for a
// shipped campaign, and that of the campaign's file for any other, whatever its name is.
std::filesystem::path baselines_of(const CampaignDefinition& campaign,
                                   const Installation& installation);

// Returns the file of the campaign's baselines. Throws CaseFileError for a ledger that the user
// names and that holds no approval, unless a new one is to be begun.
std::filesystem::path ledger_of(const CampaignOptions& options, const CampaignDefinition& campaign,
                                const Installation& installation);

// A campaign with the results of its runs, compared and judged, and how the subcommands report it.

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

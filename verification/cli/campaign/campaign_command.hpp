// The subcommands that judge a campaign: campaign, report and gate. They throw as those of
// command_line.hpp do.
#pragma once

#include <atomic>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "verification/assessment/case_assessment.hpp"
#include "verification/assessment/problem_assessment.hpp"
#include "verification/campaign/campaign_run.hpp"
#include "verification/case/campaign_definition.hpp"
#include "verification/cli/command_line.hpp"

namespace slosh {

struct CampaignOptions {
  std::string campaign;
  RunSelection selection = {};  // quick, and what the user names
  bool solve = true;            // false: only what is there is read
  int at_once = 1;
  Engine engine = Engine::ninja;
  bool dry_run = false;                       // only tell what would be done
  bool resume = false;                        // there must be an earlier start to go on from
  std::optional<int> timings = {};            // repeats a run; none: as the campaign says
  std::filesystem::path store = {};           // of results; empty: <build>/store
  int inconclusive_exit = exit_inconclusive;  // where nothing is worse than inconclusive
  std::filesystem::path csv = {};             // of the verdicts; empty: none
  bool pdf = false;                           // print the report to PDF too
  std::filesystem::path experiments;          // empty: none is named
  std::filesystem::path
      output;  // empty: <build>/campaigns/<name>, with "-quick" for the quick form
  // Of baselines; none: <baselines>/<name>.jsonl, likewise.
  std::optional<std::filesystem::path> ledger = {};
  bool new_ledger = false;  // begin a ledger that is not there
};

struct AssessedCampaign {
  CampaignDefinition definition;
  // Of the report and the gate's files: <options.output>, of a selection its folder selected/, so
  // that a part is never taken for the whole.
  std::filesystem::path output;
  std::vector<CaseAssessment> cases;
  std::vector<ProblemAssessment> problems;
};

// Runs what is not there yet, if the options say so, compares and judges.
AssessedCampaign assess_campaign(const CampaignOptions& options, const Installation& installation,
                                 const std::atomic<bool>& stop);

// Throws CaseFileError where the user names a ledger that holds no approval, unless a new one is to
// be begun.
std::filesystem::path ledger_of(const CampaignOptions& options, const CampaignDefinition& campaign,
                                const Installation& installation);

// Both print each row and leave the report. Throws CaseFileError, before anything runs, where a PDF
// is asked for and there is no browser to print it.
int run_campaign(const CampaignOptions& options, const Installation& installation,
                 const std::atomic<bool>& stop);

// Prints each row and what has moved since the baseline, or that there is none, and leaves
// <output>/gate/junit.xml, gate.md and gate.sarif.
int gate_campaign(const CampaignOptions& options, const Installation& installation,
                  const std::atomic<bool>& stop);

}  // namespace slosh

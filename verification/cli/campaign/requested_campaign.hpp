// The options of the subcommands that work on a campaign, and the campaign as they request it, with
// its files read and checked, then with its results.
#pragma once

#include <atomic>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "verification/assessment/case_assessment.hpp"
#include "verification/assessment/problem_assessment.hpp"
#include "verification/campaign/campaign_settings.hpp"
#include "verification/case/campaign_definition.hpp"
#include "verification/cli/command_tree.hpp"
#include "verification/gate/gate.hpp"

namespace slosh {

struct CampaignOptions {
  std::string campaign;
  RunSelection selection = {};  // --quick, --only and --tag
  bool report_only = false;     // only read existing results
  int at_once = 1;
  Engine engine = Engine::ninja;
  bool dry_run = false;              // only print what would be done
  bool resume = false;               // require an earlier start, and continue it
  std::optional<int> timings = {};   // repeats of each run; absent: as the campaign says
  std::filesystem::path store = {};  // of results; empty: <build>/store
  // The exit status if nothing is worse than inconclusive.
  int inconclusive_exit = exit_inconclusive;
  bool all = false;                   // one report over all campaigns of the output directory
  std::filesystem::path experiments;  // empty: none is named
  // Empty: <build>/campaigns/<name>, with "-quick" for the quick form.
  std::filesystem::path output;
  // The ledger of baselines; absent: as baselines_of() says, <name>.jsonl, likewise.
  std::optional<std::filesystem::path> ledger = {};
  bool new_ledger = false;  // begin a new ledger
};

// Each of these adds a few options to a command.
void add_campaign_options(CLI::App& command, CampaignOptions& options);
void add_ledger_option(CLI::App& command, CampaignOptions& options);
// The selection, the launch, and the exit status of inconclusive rows.
void add_start_options(CLI::App& command, CampaignOptions& options);

template <class Act>
AddedCommand<CampaignOptions> add_command_on_campaign(const CommandTree& tree,
                                                      const CommandText& text, Act act) {
  const auto added = add_command_with<CampaignOptions>(tree, text, act);
  add_campaign_options(added.command, added.options);
  add_shared_store_option(added.command, added.options.store, tree.installation);
  return added;
}

// The arguments of the examples that several commands show.
inline constexpr const char* example_run =
    "verification --only 'standing_wave/recommended_20mm' -o wave";

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

// A campaign with the results of its runs, compared and judged.
struct AssessedCampaign {
  CampaignDefinition definition;
  std::filesystem::path output;  // RequestedCampaign::place
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

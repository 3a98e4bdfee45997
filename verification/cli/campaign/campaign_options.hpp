// The options of the subcommands that work on a campaign.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "verification/campaign/campaign_settings.hpp"
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
void add_selection_options(CLI::App& command, RunSelection& selection);
void add_inconclusive_option(CLI::App& command, CampaignOptions& options);
void add_ledger_option(CLI::App& command, CampaignOptions& options);
void add_new_ledger_option(CLI::App& command, CampaignOptions& options);
void add_launch_options(CLI::App& command, CampaignOptions& options);

// Adds a command and gives it options of its own: the environment fills in the options of every
// command, whether the command is called or not.
template <class Command>
std::pair<CLI::App*, std::shared_ptr<CampaignOptions>> add_command_on_campaign(
    const CommandTree& tree, const CommandText& text, Command command) {
  auto options = std::make_shared<CampaignOptions>();
  CLI::App& added = add_command(tree, text, [options, command] { return command(*options); });
  add_campaign_options(added, *options);
  add_shared_store_option(added, options->store, tree.installation);
  return {&added, options};
}

// The arguments of the examples that several commands show.
inline constexpr const char* example_run =
    "verification --only 'standing_wave/recommended_20mm' -o wave";

}  // namespace slosh

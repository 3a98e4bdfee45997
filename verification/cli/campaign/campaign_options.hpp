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

}  // namespace slosh

#include "verification/cli/campaign/campaign_options.hpp"

#include <filesystem>

namespace slosh {

void add_campaign_options(CLI::App& command, CampaignOptions& options) {
  add_option(command, "name", options.campaign, campaign_type,
             "A campaign of `slosh list`, or the path of a campaign file")
      ->required();
  command.add_flag("--quick", options.selection.quick,
                   "Only the runs that the cases mark as quick");
  add_option(command, "-o,--output", options.output, directory_type,
             "Directory of the results and the report (default: build/campaigns/NAME, with "
             "-quick after the NAME of a quick form)")
      ->check([](const std::string& named) {
        const bool is_other =
            std::filesystem::exists(named) && !std::filesystem::is_directory(named);
        return is_other ? named + ": expected a directory" : std::string();
      });
  add_experiments_option(command, options.experiments);
}

void add_ledger_option(CLI::App& command, CampaignOptions& options) {
  add_option(command, "--ledger", options.ledger, file_type,
             "The baselines' ledger (default: NAME.jsonl, with -quick after the NAME of a quick "
             "form, in verification/baselines or, of a campaign of yours, beside its file)");
}

void add_start_options(CLI::App& command, CampaignOptions& options) {
  add_option(command, "--only", options.selection.only, pattern_type,
             "Only the cases (CASE), runs (CASE/RUN) or problems that this pattern matches, "
             "and what judges them; may be given again. The report goes to selected/")
      ->allow_extra_args(false);
  add_option(command, "--tag", options.selection.tags, tag_type,
             "Only the cases with this tag; may be given again")
      ->allow_extra_args(false);
  add_option(command, "--inconclusive-exit", options.inconclusive_exit, "N",
             "Exit status where rows are inconclusive and nothing is worse (default: 5)")
      ->check(keeps(integer_between(0, largest_exit)));
  add_jobs_option(command, options.at_once, "Runs side by side");
  command
      .add_option_function<std::string>(
          "--launcher",
          [&options](const std::string& name) {
            options.engine = name == "slurm" ? Engine::slurm : Engine::ninja;
          },
          "What runs them: ninja, on this machine (default), or slurm, on a cluster")
      ->check(unnamed(one_of("an engine", {"ninja", "slurm"})))
      ->type_name("ENGINE");
  add_option(command, "--timings", options.timings, "N",
             "Repeats of each run, one at a time, for its timings (default: as the campaign says)")
      ->check(keeps(at_least(0)));
}

}  // namespace slosh

#include "verification/cli/campaign/campaign_options.hpp"

#include <filesystem>

namespace slosh {

void add_campaign_options(CLI::App& command, CampaignOptions& options) {
  command
      .add_option("name", options.campaign,
                  "A campaign of `slosh list`, or the path of a campaign file")
      ->type_name(campaign_type)
      ->required();
  command.add_flag("--quick", options.selection.quick,
                   "Only the runs that the cases mark as quick");
  command
      .add_option("-o,--output", options.output,
                  "Directory of the results and the report (default: build/campaigns/NAME, with "
                  "-quick after the NAME of a quick form)")
      ->type_name(directory_type)
      ->check([](const std::string& named) {
        const bool is_other =
            std::filesystem::exists(named) && !std::filesystem::is_directory(named);
        return is_other ? named + ": expected a directory" : std::string();
      });
  add_experiments_option(command, options.experiments);
}

void add_selection_options(CLI::App& command, RunSelection& selection) {
  command
      .add_option("--only", selection.only,
                  "Only the cases (CASE), runs (CASE/RUN) or problems that this pattern matches, "
                  "and what judges them; may be given again. The report goes to selected/")
      ->type_name(pattern_type)
      ->allow_extra_args(false);
  command.add_option("--tag", selection.tags, "Only the cases with this tag; may be given again")
      ->type_name(tag_type)
      ->allow_extra_args(false);
}

void add_inconclusive_option(CLI::App& command, CampaignOptions& options) {
  command
      .add_option("--inconclusive-exit", options.inconclusive_exit,
                  "Exit status where rows are inconclusive and nothing is worse (default: 5)")
      ->type_name("N")
      ->check(keeps(integer_between(0, largest_exit)));
}

void add_ledger_option(CLI::App& command, CampaignOptions& options) {
  command
      .add_option(
          "--ledger", options.ledger,
          "The baselines' ledger (default: NAME.jsonl, with -quick after the NAME of a quick "
          "form, in verification/baselines or, of a campaign of yours, beside its file)")
      ->type_name(file_type);
}

void add_new_ledger_option(CLI::App& command, CampaignOptions& options) {
  command.add_flag("--new", options.new_ledger, "Begin a ledger that is not there yet");
}

void add_launch_options(CLI::App& command, CampaignOptions& options) {
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
  command
      .add_option(
          "--timings", options.timings,
          "Repeats of each run, one at a time, for its timings (default: as the campaign says)")
      ->type_name("N")
      ->check(keeps(at_least(0)));
}

}  // namespace slosh

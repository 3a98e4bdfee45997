// The options of campaign, report, gate, selftest and baseline.

#include <memory>
#include <utility>

#include "verification/cli/campaign/baseline_command.hpp"
#include "verification/cli/campaign/campaign_command.hpp"
#include "verification/cli/campaign/selftest_command.hpp"
#include "verification/cli/command_tree.hpp"

namespace slosh {
namespace {

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
      ->type_name(directory_type);
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
      ->check(keeps<int>(
          {"an integer from 0 to 125", [](int status) { return status >= 0 && status <= 125; }}));
}

void add_pdf_option(CLI::App& command, CampaignOptions& options) {
  command.add_flag("--pdf", options.pdf,
                   "Leave the whole report as report.pdf too; needs chromium");
}

void add_csv_option(CLI::App& command, CampaignOptions& options) {
  command
      .add_option("--csv", options.csv,
                  "Leave the verdict of each row here too, as a table of comma-separated values")
      ->type_name(file_type);
}

void add_ledger_option(CLI::App& command, CampaignOptions& options) {
  command
      .add_option("--ledger", options.ledger,
                  "The baselines' ledger (default: verification/baselines/NAME.jsonl, with "
                  "-quick after the NAME of a quick form)")
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
      .add_option("--timings", options.timings,
                  "Repeats of each run, alone, for its timings (default: what the campaign says)")
      ->type_name("N")
      ->check(keeps(at_least(0)));
}

void add_start_options(CLI::App& command, CampaignOptions& options) {
  command.add_flag("--dry-run", options.dry_run,
                   "Only tell what would be run, what that costs and what is kept");
  command.add_flag("--resume", options.resume,
                   "Go on from an earlier start, which there must have been");
}

using SharedOptions = std::shared_ptr<CampaignOptions>;

// With options of its own: the environment fills in those of every command, asked for or not.
template <class Command>
std::pair<CLI::App*, SharedOptions> add_command_on_campaign(const CommandTree& tree,
                                                            const CommandText& text,
                                                            Command command) {
  auto options = std::make_shared<CampaignOptions>();
  CLI::App& added = add_command(tree, text, [options, command] { return command(*options); });
  add_campaign_options(added, *options);
  add_shared_store_option(added, options->store, tree.installation);
  return {&added, options};
}

const std::string one_run = "verification --only 'standing_wave/recommended_20mm' -o wave";

void add_campaign_and_report(const CommandTree& tree) {
  const auto judge = [tree](CampaignOptions options, bool solve) {
    tree.stop_on_signals();
    options.solve = solve;
    return run_campaign(options, tree.installation, tree.stop);
  };
  const auto [campaign, campaign_options] = add_command_on_campaign(
      tree,
      {"campaign",
       "Runs a campaign's cases, compares, reports and gates",
       {"./slosh campaign " + one_run, "./slosh campaign verification --only kernels -o problems",
        "./slosh campaign small_amplitude --dry-run"}},
      [judge](const CampaignOptions& options) { return judge(options, true); });
  add_selection_options(*campaign, campaign_options->selection);
  add_inconclusive_option(*campaign, *campaign_options);
  add_pdf_option(*campaign, *campaign_options);
  add_csv_option(*campaign, *campaign_options);
  add_launch_options(*campaign, *campaign_options);
  add_start_options(*campaign, *campaign_options);
  const auto [report, report_options] = add_command_on_campaign(
      tree,
      {"report",
       "The same from the results that are there; starts no solver",
       {"./slosh report " + one_run}},
      [judge](const CampaignOptions& options) { return judge(options, false); });
  add_selection_options(*report, report_options->selection);
  add_inconclusive_option(*report, *report_options);
  add_pdf_option(*report, *report_options);
  add_csv_option(*report, *report_options);
}

void add_gate_and_selftest(const CommandTree& tree) {
  const auto [gate, gate_options] = add_command_on_campaign(
      tree,
      {"gate",
       "Runs what a campaign still needs, tells what has moved since its baseline, and leaves "
       "junit.xml, gate.md and gate.sarif",
       {"./slosh gate " + one_run + " --inconclusive-exit 0"}},
      [tree](const CampaignOptions& options) {
        tree.stop_on_signals();
        return gate_campaign(options, tree.installation, tree.stop);
      });
  add_selection_options(*gate, gate_options->selection);
  add_inconclusive_option(*gate, *gate_options);
  add_csv_option(*gate, *gate_options);
  add_launch_options(*gate, *gate_options);
  add_ledger_option(*gate, *gate_options);
  const auto record = std::make_shared<bool>(false);
  const auto [selftest, selftest_options] =
      add_command_on_campaign(tree,
                              {"selftest",
                               "Whether the gate rows detect what they claim to, and those of each "
                               "case together what every "
                               "case must detect, on the results that are there",
                               {"./slosh selftest " + one_run}},
                              [tree, record](const CampaignOptions& options) {
                                return selftest_campaign({options, *record}, tree.installation);
                              });
  add_selection_options(*selftest, selftest_options->selection);
  add_jobs_option(*selftest, selftest_options->at_once, "Rows tried side by side");
  selftest->add_flag("--record", *record,
                     "Leave what was found as verification/baselines/NAME.selftest.json, with "
                     "-quick after the NAME of a quick form");
}

}  // namespace

void add_campaign_commands(const CommandTree& tree) {
  add_campaign_and_report(tree);
  add_gate_and_selftest(tree);
}

void add_baseline_commands(const CommandTree& tree) {
  CLI::App& baseline = *tree.app.add_subcommand(
      "baseline", "Our own earlier figures of a campaign, and what has moved since");
  baseline.require_subcommand(1);
  const CommandTree below{baseline, tree.installation, tree.stop, tree.stop_on_signals,
                          tree.action};
  const std::string example = " verification -o wave --ledger wave.jsonl --new";
  const Installation& installation = tree.installation;
  const auto [diff, diff_options] =
      add_command_on_campaign(below,
                              {"diff",
                               "Prints what has changed; exit status 1 where something has",
                               {"./slosh baseline diff" + example}},
                              [&installation](const CampaignOptions& options) {
                                return diff_baseline(options, installation);
                              });
  const auto [propose, propose_options] =
      add_command_on_campaign(below,
                              {"propose",
                               "Leaves a proposal to make the present figures the baseline",
                               {"./slosh baseline propose" + example}},
                              [&installation](const CampaignOptions& options) {
                                return propose_baseline(options, installation);
                              });
  auto approval = std::make_shared<ApprovalOptions>();
  const auto [approve, approve_options] = add_command_on_campaign(
      below,
      {"approve",
       "Adds the proposal to the ledger",
       {"./slosh baseline approve" + example + " --who 'A. Name' --reason 'The first figures.'"}},
      [&installation, approval](const CampaignOptions& options) {
        return approve_baseline(options, *approval, installation);
      });
  add_ledger_option(*diff, *diff_options);
  add_ledger_option(*propose, *propose_options);
  add_ledger_option(*approve, *approve_options);
  add_new_ledger_option(*diff, *diff_options);
  add_new_ledger_option(*propose, *propose_options);
  add_new_ledger_option(*approve, *approve_options);
  const CLI::Validator not_empty(
      [](const std::string& text) { return text.empty() ? "expected a text" : std::string(); }, "");
  approve->add_option("--who", approval->who, "Who approves it")->required()->check(not_empty);
  approve->add_option("--reason", approval->reason, "Why the figures may move")
      ->required()
      ->check(not_empty);
}

}  // namespace slosh

// The tool `slosh`: reads the command line, starts a subcommand, turns errors into messages and
// exit statuses.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <csignal>
#include <filesystem>
#include <functional>
#include <iostream>
#include <memory>
#include <thread>
#include <utility>

#include "verification/baseline/baseline_ledger.hpp"
#include "verification/baseline_command.hpp"
#include "verification/campaign_command.hpp"
#include "verification/case_file/case_file_error.hpp"
#include "verification/command_line.hpp"
#include "verification/gate/gate.hpp"
#include "verification/problem_command.hpp"
#include "verification/runs/run_case.hpp"
#include "verification/selftest_command.hpp"

namespace {

std::atomic<bool> stop_requested{false};

void request_stop(int) { stop_requested = true; }

slosh::Installation installation() {
  namespace fs = std::filesystem;
  const fs::path source = SLOSH_SOURCE_DIR;
  const fs::path executable = fs::read_symlink("/proc/self/exe");
  return {executable,
          executable.parent_path() / "slosh.solver",
          executable.parent_path() / "slosh.problems",
          source,
          source / "verification/cases",
          source / "verification/campaigns",
          source / "verification/baselines",
          source / "openfoam_cases/sloshing_tank",
          source / "build"};
}

constexpr const char* closing_words =
    "The launcher ./slosh also knows: test (builds and runs the tests), doctor (what is "
    "installed).\n"
    "Exit status: 0 all gate rows hold; 1 a tolerance is violated; 2 usage or case-file error; 3 a "
    "solver failed;\n"
    "4 a reference is missing, a result is unusable or nothing was compared; 5 a row is "
    "inconclusive; 130 interrupted.\n"
    "Examples:\n"
    "  ./slosh campaign small_amplitude --quick\n"
    "  ./slosh run li2010_small_amplitude linear --output linear.h5\n"
    "  ./slosh problem kernels --quick --output kernels.json";

void add_experiments_option(CLI::App& command, std::filesystem::path& experiments) {
  command
      .add_option("--experiments", experiments,
                  "Directory of the experimental records that you have; without it the runs that "
                  "need one are told as not supplied")
      ->envname("SLOSH_EXPERIMENTS")
      ->check(CLI::ExistingDirectory);
}

void add_campaign_options(CLI::App& command, slosh::CampaignOptions& options) {
  command
      .add_option("name", options.campaign,
                  "A campaign of `slosh list`, or the path of a campaign file")
      ->required();
  command.add_flag("--quick", options.quick, "Only the runs that the cases mark as quick");
  command.add_option(
      "-o,--output", options.output,
      "Directory of the results and the report (default: build/campaigns/NAME, with -quick "
      "after the NAME of a quick form)");
  add_experiments_option(command, options.experiments);
}

void add_inconclusive_option(CLI::App& command, slosh::CampaignOptions& options) {
  command
      .add_option("--inconclusive-exit", options.inconclusive_exit,
                  "Exit status where rows are inconclusive and nothing is worse (default: 5)")
      ->check(CLI::Range(0, 125));
}

void add_pdf_option(CLI::App& command, slosh::CampaignOptions& options) {
  command.add_flag("--pdf", options.pdf,
                   "Leave the whole report as report.pdf too; needs chromium");
}

void add_ledger_option(CLI::App& command, slosh::CampaignOptions& options) {
  command.add_option("--ledger", options.ledger,
                     "The baselines' ledger (default: verification/baselines/NAME.jsonl, with "
                     "-quick after the NAME of a quick form)");
}

void add_jobs_option(CLI::App& command, slosh::CampaignOptions& options) {
  command.add_option("-j,--jobs", options.at_once, "Runs side by side (default: one a core)")
      ->check(CLI::PositiveNumber);
}

void add_run_options(CLI::App& command, slosh::RunOptions& options) {
  command
      .add_option("case", options.case_name, "A case of `slosh list`, or the path of a case file")
      ->required();
  command.add_option("run", options.run, "The run's name in the case")->required();
  command.add_option("-o,--output", options.output, "Result file (default: RUN.h5)");
  command
      .add_option(
          "--snapshots", options.snapshot_interval,
          "Interval of particle snapshots for ParaView [s], of an SPH run: a multiple of the "
          "case's sample_interval_s")
      ->check(CLI::PositiveNumber);
  command
      .add_option("--states", options.state_interval,
                  "Interval at which the state of an SPH run is saved beside its result [s]: a "
                  "multiple of the case's sample_interval_s")
      ->check(CLI::PositiveNumber);
  command
      .add_option("--resume", options.resume,
                  "A saved state that the run goes on from, bit for bit (with the same --states)")
      ->check(CLI::ExistingFile);
  add_experiments_option(command, options.experiments);
  command.add_option("--progress-file", options.progress_file, "Where to tell how far the run is");
}

// What the command line asks for, chosen while it is parsed.
using Action = std::function<int()>;

template <class Command>
CLI::App& add_command(CLI::App& app, const char* name, const char* description, Action& action,
                      Command command) {
  CLI::App& added = *app.add_subcommand(name, description);
  added.callback([&action, command] { action = command; });
  return added;
}

void add_problem_options(CLI::App& command, slosh::ProblemOptions& options) {
  command.add_option("name", options.problem, "A problem of `slosh list`")->required();
  command.add_flag("--quick", options.quick, "Without the finest resolutions");
  command.add_option("-o,--output", options.output, "Result file (default: NAME.json)");
}

// A command on a campaign, with options of its own: the environment fills in those of every
// command, asked for or not.
template <class Command>
std::pair<CLI::App*, std::shared_ptr<slosh::CampaignOptions>> add_campaign_command(
    CLI::App& app, const char* name, const char* description, Action& action, Command command) {
  auto options = std::make_shared<slosh::CampaignOptions>();
  options->at_once = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  CLI::App& added =
      add_command(app, name, description, action, [options, command] { return command(*options); });
  add_campaign_options(added, *options);
  return {&added, options};
}

// A run that is ended ends; a campaign ends its runs first.
void stop_on_signals() {
  std::signal(SIGINT, request_stop);
  std::signal(SIGTERM, request_stop);
}

void add_campaign_commands(CLI::App& app, Action& action) {
  const auto [campaign, campaign_options] =
      add_campaign_command(app, "campaign", "Runs a campaign's cases, compares, reports and gates",
                           action, [](const slosh::CampaignOptions& options) {
                             stop_on_signals();
                             return slosh::run_campaign(options, installation(), stop_requested);
                           });
  const auto [report, report_options] = add_campaign_command(
      app, "report", "The same from the results that are there; starts no solver", action,
      [](slosh::CampaignOptions options) {
        stop_on_signals();
        options.solve = false;
        return slosh::run_campaign(options, installation(), stop_requested);
      });
  const auto [gate, gate_options] = add_campaign_command(
      app, "gate",
      "Runs what a campaign still needs, tells what has moved since its baseline, and leaves "
      "junit.xml, gate.md and gate.sarif",
      action, [](const slosh::CampaignOptions& options) {
        stop_on_signals();
        return slosh::gate_campaign(options, installation(), stop_requested);
      });
  add_campaign_command(
      app, "selftest",
      "Whether the gate rows detect what they claim to, on the results that are there", action,
      [](const slosh::CampaignOptions& options) {
        return slosh::selftest_campaign(options, installation());
      });
  add_inconclusive_option(*campaign, *campaign_options);
  add_inconclusive_option(*report, *report_options);
  add_inconclusive_option(*gate, *gate_options);
  add_pdf_option(*campaign, *campaign_options);
  add_pdf_option(*report, *report_options);
  add_jobs_option(*campaign, *campaign_options);
  add_jobs_option(*gate, *gate_options);
  add_ledger_option(*gate, *gate_options);
}

void add_baseline_commands(CLI::App& app, slosh::ApprovalOptions& approval, Action& action) {
  CLI::App& baseline = *app.add_subcommand(
      "baseline", "Our own earlier figures of a campaign, and what has moved since");
  baseline.require_subcommand(1);
  const auto [diff, diff_options] = add_campaign_command(
      baseline, "diff", "Prints what has changed; exit status 1 where something has", action,
      [](const slosh::CampaignOptions& options) {
        return slosh::diff_baseline(options, installation());
      });
  const auto [propose, propose_options] = add_campaign_command(
      baseline, "propose", "Leaves a proposal to make the present figures the baseline", action,
      [](const slosh::CampaignOptions& options) {
        return slosh::propose_baseline(options, installation());
      });
  const auto [approve, approve_options] =
      add_campaign_command(baseline, "approve", "Adds the proposal to the ledger", action,
                           [&approval](const slosh::CampaignOptions& options) {
                             return slosh::approve_baseline(options, approval, installation());
                           });
  add_ledger_option(*diff, *diff_options);
  add_ledger_option(*propose, *propose_options);
  add_ledger_option(*approve, *approve_options);
  const CLI::Validator not_empty(
      [](const std::string& text) { return text.empty() ? "expected a text" : std::string(); },
      "TEXT");
  approve->add_option("--who", approval.who, "Who approves it")->required()->check(not_empty);
  approve->add_option("--reason", approval.reason, "Why the figures may move")
      ->required()
      ->check(not_empty);
}

int dispatch(int argc, char** argv) {
  CLI::App app{"Verifies and validates SPH on sloshing tanks against theory and interFoam."};
  app.footer(closing_words);
  app.require_subcommand(1);
  slosh::ApprovalOptions approval;
  slosh::RunOptions run;
  slosh::ProblemOptions problem;
  Action action;
  add_campaign_commands(app, action);
  add_baseline_commands(app, approval, action);
  add_run_options(add_command(app, "run", "Executes one run of a case and leaves its result file",
                              action, [&] { return slosh::run_one(run, installation()); }),
                  run);
  add_problem_options(
      add_command(app, "problem",
                  "Solves one verification problem and leaves its errors over the resolutions",
                  action, [&] { return slosh::run_problem(problem, installation()); }),
      problem);
  add_command(app, "list", "Lists campaigns, cases and their runs, and problems", action,
              [] { return slosh::list_definitions(installation()); });

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? slosh::exit_pass : slosh::exit_usage;
  }
  return action();
}

}  // namespace

int main(int argc, char** argv) {
  const auto fail = [](const std::exception& error, int status) {
    std::cerr << "slosh: " << error.what() << "\n";
    return status;
  };
  try {
    return dispatch(argc, argv);
  } catch (const slosh::CaseFileError& error) {
    return fail(error, slosh::exit_usage);
  } catch (const slosh::InterruptedError& error) {
    return fail(error, slosh::exit_interrupted);
  } catch (const slosh::SolverError& error) {
    return fail(error, slosh::exit_solver_failed);
  } catch (const std::exception& error) {
    // A result or a report that could not be written: nothing was compared. An interrupt ends the
    // plotter too, and then is the cause.
    return fail(error, stop_requested ? slosh::exit_interrupted : slosh::exit_not_compared);
  }
}

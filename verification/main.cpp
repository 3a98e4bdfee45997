// The tool `slosh`: reads the command line, starts a subcommand, turns errors into messages and
// exit statuses.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <csignal>
#include <filesystem>
#include <iostream>
#include <thread>

#include "verification/campaign/campaign_run.hpp"
#include "verification/case_file/case_file_error.hpp"
#include "verification/command_line.hpp"
#include "verification/gate/gate.hpp"
#include "verification/runs/run_case.hpp"

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
          source / "verification/cases",
          source / "verification/campaigns",
          source / "openfoam_cases/sloshing_tank",
          source / "build"};
}

constexpr const char* closing_words =
    "The launcher ./slosh also knows: test (builds and runs the tests), doctor (what is "
    "installed).\n"
    "Exit status: 0 all gate rows hold; 1 a tolerance is violated; 2 usage or case-file error; 3 a "
    "solver failed;\n"
    "4 a reference is missing, a result is unusable or nothing was compared; 130 interrupted.\n"
    "Examples:\n"
    "  ./slosh campaign small_amplitude --quick\n"
    "  ./slosh run li2010_small_amplitude linear --output linear.h5";

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

void add_problem_options(CLI::App& command, slosh::ProblemOptions& options) {
  command.add_option("name", options.problem, "A problem of `slosh list`")->required();
  command.add_flag("--quick", options.quick, "Without the finest resolutions");
  command.add_option("-o,--output", options.output, "Result file (default: NAME.json)");
}

int dispatch(int argc, char** argv) {
  CLI::App app{"Verifies and validates SPH on sloshing tanks against theory and interFoam."};
  app.footer(closing_words);
  app.require_subcommand(1);
  slosh::CampaignOptions campaign;
  campaign.at_once = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  slosh::RunOptions run;
  slosh::ProblemOptions problem;
  CLI::App& campaign_command =
      *app.add_subcommand("campaign", "Runs a campaign's cases, compares, reports and gates");
  CLI::App& report_command =
      *app.add_subcommand("report", "The same from the results that are there; starts no solver");
  CLI::App& run_command =
      *app.add_subcommand("run", "Executes one run of a case and leaves its result file");
  CLI::App& problem_command = *app.add_subcommand(
      "problem", "Solves one verification problem and leaves its errors over the resolutions");
  const CLI::App& list_command =
      *app.add_subcommand("list", "Lists campaigns, cases and their runs, and problems");
  add_campaign_options(campaign_command, campaign);
  campaign_command
      .add_option("-j,--jobs", campaign.at_once, "Runs side by side (default: one a core)")
      ->check(CLI::PositiveNumber);
  add_campaign_options(report_command, campaign);
  add_run_options(run_command, run);
  add_problem_options(problem_command, problem);

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? slosh::exit_pass : slosh::exit_usage;
  }
  if (list_command) return slosh::list_definitions(installation());
  if (problem_command) return slosh::run_problem(problem, installation());
  if (run_command) return slosh::run_one(run, installation());
  std::signal(SIGINT, request_stop);
  std::signal(SIGTERM, request_stop);
  campaign.solve = !report_command;
  return slosh::run_campaign(campaign, installation(), stop_requested);
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

// The options of run and problem, which execute one thing in this process.

#include <memory>

#include "verification/commands/command_tree.hpp"
#include "verification/problem_command.hpp"

namespace slosh {
namespace {

void add_state_options(CLI::App& command, RunOptions& options) {
  command
      .add_option("--snapshots", options.snapshot_interval,
                  "Interval of particle snapshots for ParaView [s], of an SPH run: a multiple of "
                  "the case's sample_interval_s")
      ->type_name("SECONDS")
      ->check(unnamed(CLI::PositiveNumber));
  command
      .add_option("--states", options.state_interval,
                  "Interval at which the state of an SPH run is saved beside its result [s]: a "
                  "multiple of the case's sample_interval_s")
      ->type_name("SECONDS")
      ->check(unnamed(CLI::PositiveNumber));
  command
      .add_option("--resume", options.resume,
                  "A saved state that the run goes on from, bit for bit (with the same --states)")
      ->type_name(file_type)
      ->check(unnamed(CLI::ExistingFile));
}

void add_run_command(const CommandTree& tree) {
  auto options = std::make_shared<RunOptions>();
  CLI::App& command = add_command(
      tree,
      {"run",
       "Executes one run of a case and leaves its result file",
       {"./slosh run li2010_small_amplitude recommended_25mm",
        "./slosh run li2010_small_amplitude recommended_25mm --output shown.h5 --snapshots 5"}},
      [options, &installation = tree.installation] { return run_one(*options, installation); });
  command
      .add_option("case", options->case_name, "A case of `slosh list`, or the path of a case file")
      ->type_name(case_type)
      ->required();
  command.add_option("run", options->run, "The run's name in the case")
      ->type_name(run_type)
      ->required();
  command.add_option("-o,--output", options->output, "Result file (default: RUN.h5)")
      ->type_name(file_type);
  add_state_options(command, *options);
  add_experiments_option(command, options->experiments);
  command.add_option("--progress-file", options->progress_file, "Where to tell how far the run is")
      ->type_name(file_type);
}

void add_problem_command(const CommandTree& tree) {
  auto options = std::make_shared<ProblemOptions>();
  CLI::App& command = add_command(
      tree,
      {"problem",
       "Solves one verification problem and leaves its errors over the resolutions",
       {"./slosh problem kernels --quick"}},
      [options, &installation = tree.installation] { return run_problem(*options, installation); });
  command.add_option("name", options->problem, "A problem of `slosh list`")
      ->type_name(problem_type)
      ->required();
  command.add_flag("--quick", options->quick, "Without the finest resolutions");
  command.add_option("-o,--output", options->output, "Result file (default: NAME.json)")
      ->type_name(file_type);
}

}  // namespace

void add_execution_commands(const CommandTree& tree) {
  add_run_command(tree);
  add_problem_command(tree);
}

}  // namespace slosh

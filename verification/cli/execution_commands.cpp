// The options of run and problem, which execute one thing in this process.

#include <memory>

#include "verification/cli/command_tree.hpp"
#include "verification/cli/problem_command.hpp"

namespace slosh {
namespace {

void add_state_options(CLI::App& command, RunOptions& options) {
  command
      .add_option("--snapshots", options.snapshot_interval,
                  "Interval of particle snapshots for ParaView [s], of an SPH run: a multiple of "
                  "the case's sample_interval_s")
      ->type_name("SECONDS")
      ->check(keeps(positive("s")));
  command
      .add_option("--states", options.state_interval,
                  "Interval at which the state of an SPH run is saved beside its result [s]: a "
                  "multiple of the case's sample_interval_s")
      ->type_name("SECONDS")
      ->check(keeps(positive("s")));
  command
      .add_option("--resume", options.resume,
                  "A saved state that the run goes on from, bit for bit (with the same --states)")
      ->type_name(file_type)
      ->check(unnamed(CLI::ExistingFile));
}

CLI::Option* add_store_option(CLI::App& command, std::filesystem::path& store) {
  return command
      .add_option("--store", store,
                  "Directory of results: leave it there under its key, unless it is there already")
      ->type_name(directory_type);
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
  command
      .add_option("--time-limit", options->time_limit,
                  "Wall time after which interFoam is ended [s], of an interFoam run")
      ->type_name("SECONDS")
      ->check(keeps(positive("s")));
  add_experiments_option(command, options->experiments);
  command.add_option("--progress-file", options->progress_file, "Where to tell how far the run is")
      ->type_name(file_type);
  command
      .add_option("--campaign", options->campaign,
                  "A campaign, by name or path, whose sweeps add runs to the case")
      ->type_name(campaign_type);
  CLI::Option* store = add_store_option(command, options->store);
  command
      .add_flag("--timing", options->timing,
                "Repeat the run of the store and add what it takes to its timings")
      ->needs(store);
  command
      .add_option("--longest", options->longest,
                  "Not of a run that took more processor time [s] (default: of any)")
      ->type_name("SECONDS")
      ->needs("--timing");
  for (const char* other : {"--output", "--snapshots", "--states", "--resume", "--time-limit"})
    store->excludes(command.get_option(other));
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
  add_store_option(command, options->store);
}

// What the engine of a campaign starts; nobody types it.
void add_job_command(const CommandTree& tree) {
  auto index = std::make_shared<std::size_t>(0);
  CLI::App& command = add_command(
      tree, {"job", "Runs one job of the list in the current directory", {}}, [index, tree] {
        tree.stop_on_signals();
        return run_listed_job(*index, tree.stop);
      });
  command.add_option("index", *index, "Its place in jobs.cbor, from 0")->required();
  command.group("");
}

}  // namespace

void add_execution_commands(const CommandTree& tree) {
  add_run_command(tree);
  add_problem_command(tree);
  add_job_command(tree);
}

}  // namespace slosh

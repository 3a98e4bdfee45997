// The subcommand run, which executes one run of a case or solves one verification problem in this
// process, and the hidden subcommand job, by which the engine of a campaign starts its jobs.

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <iostream>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include "verification/assessment/doubts/motion_noise.hpp"
#include "verification/assessment/problem_assessment.hpp"
#include "verification/case/solver_kinds.hpp"
#include "verification/case_file/campaign_parser.hpp"
#include "verification/case_file/case_parser.hpp"
#include "verification/cli/command_tree.hpp"
#include "verification/cli/stored_run.hpp"
#include "verification/cli/texts/result_text.hpp"
#include "verification/engine/job_list.hpp"
#include "verification/engine/progress_display.hpp"
#include "verification/files/file_lock.hpp"
#include "verification/files/own_files.hpp"
#include "verification/files/protected_inputs.hpp"
#include "verification/gate/gate.hpp"
#include "verification/problems/problem_list.hpp"
#include "verification/results/progress_file.hpp"
#include "verification/results/provenance.hpp"
#include "verification/results/result_seals.hpp"
#include "verification/runs/expected_cost.hpp"
#include "verification/runs/run_case.hpp"
#include "verification/runs/run_key.hpp"
#include "verification/solvers/particles/state_file.hpp"
#include "verification/solvers/snapshots.hpp"

namespace slosh {
namespace {

namespace fs = std::filesystem;

struct RunOptions {
  std::string case_name, run;  // no run: the name is that of a problem
  bool quick = false;          // of a problem
  std::filesystem::path output, progress_file;
  std::filesystem::path experiments;  // empty: none is named
  std::filesystem::path campaign;     // name or path: its sweeps add runs; may be empty
  // The result is kept only there, under its key. Empty: the result is written to the output, and a
  // copy is kept in usual_store().
  std::filesystem::path store;
  bool timing = false;                                       // only measure, into the store
  double longest = std::numeric_limits<double>::infinity();  // [s], of a run that is timed
  double snapshot_interval = 0;                              // [s]
  double state_interval = 0;                                 // [s]
  double time_limit = 0;                                     // [s]; 0: none
  std::filesystem::path resume;                              // empty: from the start
};

// The interval at which a run writes its progress; the parent process reads it as often.
constexpr auto progress_interval = std::chrono::milliseconds(200);

Progress progress_writer(const fs::path& file, double end_time) {
  if (file.empty()) return [](double, double) {};
  return [file, end_time, last = std::chrono::steady_clock::time_point{}](double time,
                                                                          double steps) mutable {
    const auto now = std::chrono::steady_clock::now();
    if (now - last < progress_interval) return;
    last = now;
    try {
      write_progress({time, end_time, steps}, file);
    } catch (const fs::filesystem_error&) {  // a run does not fail because its progress cannot be
                                             // written
    }
  };
}

const RunDefinition& requested_run(const CaseDefinition& definition, const std::string& name) {
  std::string names;
  for (const RunDefinition& one : definition.runs) {
    if (one.name == name) return one;
    names += (names.empty() ? "" : ", ") + one.name;
  }
  throw CaseFileError(
      fmt::format("{}: run = {}: expected one of {}", definition.file.string(), name, names));
}

RunSettings settings_for(const RunOptions& options, const Installation& installation,
                         const std::string& key, fs::path file) {
  return {.work_directory = file.replace_extension(options.timing ? ".timing.work" : ".work"),
          .openfoam_templates = installation.openfoam_templates,
          .snapshot_interval = options.snapshot_interval,
          .state_interval = options.state_interval,
          .resume = options.resume,
          .time_limit = options.time_limit,
          .key = key,
          .command = {}};
}

// Returns the command that repeats the run.
std::string command_of(const RunOptions& options, const Installation& installation,
                       const CaseDefinition& definition, const RunDefinition& run) {
  const std::string campaign =
      options.campaign.empty()
          ? ""
          : " --campaign " + name_or_path(find_campaign(options.campaign, installation.campaigns),
                                          installation.campaigns);
  return fmt::format("./slosh run {} {} --output {}.h5{}{}",
                     name_or_path(definition.file, installation.cases), run.name, run.name,
                     campaign,
                     is_record(run) ? experiments_option(whole(options.experiments)) : "");
}

// Potential flow that leaves its range ends early, which is not a success.
int told_end(const RunResult& result, const CaseDefinition& definition) {
  const auto because = result.provenance.find("left_range_because");
  if (because == result.provenance.end()) return exit_pass;
  std::cerr << fmt::format("slosh: the run {} leaves its range at {:.4g} s of {:g} s: {}\n",
                           result.run_name, result.diagnostics.at("valid_until_s"),
                           definition.duration, because->second);
  return exit_not_compared;
}

// Writes the result file, prints the files beside it and returns the exit status.
int leave_result(const RunResult& result, const fs::path& file, const RunSettings& settings,
                 const CaseDefinition& definition, const RunDefinition& run) {
  write_result(result, file);
  std::cout << run_summary(result, definition, run) << "result: " << file.string() << "\n";
  if (!is_record(run)) std::cout << doubtful_motion(definition);
  if (settings.snapshot_interval != 0)
    std::cout << "snapshots: " << snapshot_index(settings.work_directory, result.run_name).string()
              << "\n";
  if (settings.state_interval != 0)
    std::cout << "state: " << state_file(settings.work_directory, result.run_name).string() << "\n";
  return told_end(result, definition);
}

// Saving a state makes the solver rebuild its neighbour lists, so that the result is not bit for
// bit that of a campaign.
bool is_as_a_campaign_computes(const RunOptions& options) {
  return options.state_interval == 0 && options.resume.empty();
}

// Returns the result of a run that is not for the store, and records a failure there all the same.
// A result of Slosh's own solvers that stands under the key outlives a failure here: the disk or
// the directory was another.
RunResult attempted(const RunDefinition& run, const ResultStore& store, const std::string& key,
                    const std::function<RunResult()>& compute) {
  const bool is_program = solver_kind(run).answered_with == AnsweredWith::user_program;
  const ResultSeals seals(is_program ? store.results() : std::vector<fs::path>());
  try {
    RunResult result = compute();
    seals.require_unchanged();
    return result;
  } catch (const SolverError& error) {
    if (is_program || !fs::exists(store.file(key, ".h5"))) keep_failure(store, key, error.failure);
    throw;
  }
}

// Refuses outputs onto inputs before anything is computed. A run that goes on from a state in its
// own directory may save another one there.
void require_safe_outputs(const RunOptions& options, const fs::path& work_directory) {
  std::error_code absent;
  if (!fs::equivalent(options.resume.parent_path(), work_directory, absent))
    protect_input(options.resume);
  require_progress_place(options.progress_file);
}

int run_listed_job(std::size_t index, const std::atomic<bool>& stop) {
  run_job(JobList::open(fs::current_path()), index, stop);
  return exit_pass;  // the list records how it ended
}

// Of a run that leaves more than its result; waits for another start there.
std::optional<FileLock> lock_work_directory(const RunDefinition& run, const RunSettings& settings) {
  const AnsweredWith kind = solver_kind(run).answered_with;
  if (kind != AnsweredWith::openfoam && kind != AnsweredWith::user_program &&
      settings.snapshot_interval == 0 && settings.state_interval == 0)
    return {};
  const fs::path file = settings.work_directory / "lock";
  require_own(file);
  return std::optional<FileLock>(std::in_place, file,
                                 telling_once("works in " + settings.work_directory.string()));
}

// Throws SolverError if the solver fails.
ProblemOutcome outcome_of(const Problem& problem, bool quick) try {
  return problem.run(quick);
} catch (const std::runtime_error& error) {
  throw SolverError(error.what());
}

ProblemResult solved(const Problem& problem, bool quick, const std::string& key) {
  const CostMeter meter;
  ProblemResult result;
  result.problem = problem.name;
  result.quick = quick;
  result.key = key;
  result.provenance =
      provenance(fmt::format("./slosh run {}{}", problem.name, quick ? " --quick" : ""));
  result.outcome = outcome_of(problem, quick);
  result.cost = meter.cost();
  return result;
}

void print(const ProblemOutcome& outcome) {
  for (const MeasuredErrors& measure : outcome.measures) {
    std::cout << measure.name << ":";
    for (const ErrorAtStep& one : measure.errors) std::cout << fmt::format(" {:.3g}", one.error);
    if (const auto order = order_of(measure.errors))
      std::cout << fmt::format(", order {:.2f}", *order);
    std::cout << "\n";
  }
}

int run_problem(const Problem& problem, const RunOptions& options,
                const Installation& installation) {
  const std::string key = problem_key(problem, options.quick, installation.builds);
  const auto compute = [&] {
    ProblemResult result = solved(problem, options.quick, key);
    print(result.outcome);
    return result;
  };
  if (!options.store.empty()) {
    keep_problem(ResultStore(whole(options.store)), key, compute);
    return exit_pass;
  }
  const fs::path file = options.output.empty() ? fs::path(problem.name + ".json") : options.output;
  const OpenOutputs output(file, "run");
  const ProblemResult result = compute();
  output.make_room();
  write_problem_result(result, file);
  std::cout << "result: " << file.string() << "\n";
  return exit_pass;
}

// Returns the problem that takes the place of a case and its run; nullptr where one is missing.
const Problem* named_problem(const RunOptions& options, const Installation& installation) {
  if (!options.run.empty()) return nullptr;
  std::string no_problem;
  try {
    return &find_problem(options.case_name);
  } catch (const std::invalid_argument& error) {
    no_problem = error.what();
  }
  try {
    find_case(options.case_name, installation.cases);
  } catch (const CaseFileError& no_case) {
    throw CaseFileError(fmt::format("{}; or {}", no_case.what(), no_problem));
  }
  return nullptr;
}

int run_one(const RunOptions& options, const Installation& installation) {
  if (const Problem* problem = named_problem(options, installation))
    return run_problem(*problem, options, installation);
  const fs::path experiments = whole(options.experiments);
  CaseDefinition definition =
      read_case(find_case(options.case_name, installation.cases), experiments);
  if (!options.campaign.empty())
    add_swept_runs(read_campaign(find_campaign(options.campaign, installation.campaigns),
                                 installation.cases, known_problems()),
                   definition);
  const RunDefinition& run = requested_run(definition, options.run);
  const auto contents = files_read_by(run, definition);  // before the key: a change is seen
  const std::string key =
      run_key(definition, run, installation.builds, installation.openfoam_templates);
  const ResultStore store(whole(options.store));
  const fs::path file = !options.store.empty()   ? store.file(key, ".h5")
                        : options.output.empty() ? fs::path(run.name + ".h5")
                                                 : options.output;
  RunSettings settings = settings_for(options, installation, key, file);
  settings.command = command_of(options, installation, definition, run);
  require_safe_outputs(options, settings.work_directory);
  const ExpectedCost expected =
      expected_cost(definition, run, key, ResultStore(usual_store(installation)));
  const auto compute = [&] {
    RunDisplay display(std::cerr, style_now_of(STDERR_FILENO), definition.name + "/" + run.name,
                       expected.wall_time);
    const Progress write = progress_writer(options.progress_file, definition.duration);
    RunResult result = execute(definition, run, settings, [&](double time, double steps) {
      display.tell({time, definition.duration, steps});
      write(time, steps);
    });
    require_unchanged(contents);
    return result;
  };
  // For a run in the store the campaign judges whether it reaches the end of the comparison window.
  if (options.timing) {
    time_run(store, key, options.longest, compute);
    return exit_pass;
  }
  if (!options.store.empty()) {
    keep_run(store, key, [&] {
      RunResult result = compute();
      record_cost(result, definition, run, store);
      return result;
    });
    return exit_pass;
  }
  const ResultStore usual(usual_store(installation));
  const OpenOutputs output(file, "run");
  const std::optional<FileLock> lock = lock_work_directory(run, settings);
  const bool is_attempt = is_as_a_campaign_computes(options) && options.time_limit == 0;
  const RunResult result = is_attempt ? attempted(run, usual, key, compute) : compute();
  output.make_room();
  const int status = leave_result(result, file, settings, definition, run);
  if (is_as_a_campaign_computes(options)) keep_copy(usual, key, result);
  return status;
}

void add_state_options(CLI::App& command, RunOptions& options) {
  add_option(command, "--snapshots", options.snapshot_interval, "SECONDS",
             "Interval of particle snapshots for ParaView [s], of an SPH run: a multiple of "
             "the case's sample_interval_s")
      ->check(keeps(positive("s")));
  add_option(command, "--states", options.state_interval, "SECONDS",
             "Interval at which the state of an SPH run is saved beside its result [s]: a "
             "multiple of the case's sample_interval_s")
      ->check(keeps(positive("s")));
  add_option(command, "--resume", options.resume, file_type,
             "A saved state from which the run continues, bit for bit (with the same --states)")
      ->check(unnamed(CLI::ExistingFile));
}

}  // namespace

void add_run_command(const CommandTree& tree) {
  const auto [command, options] = add_command_with<RunOptions>(
      tree,
      {"run",
       "Executes one run of a case, or solves one verification problem, and writes its result file",
       {"./slosh run li2010_small_amplitude recommended_25mm",
        "./slosh run li2010_small_amplitude recommended_25mm --output shown.h5 --snapshots 5",
        "./slosh run rigid_rotation --quick"}},
      run_one);
  add_case_argument(command, options.case_name,
                    "A case or problem of `slosh list`, or the path of a case file")
      ->required();
  CLI::Option* run = add_option(command, "run", options.run, run_type,
                                "The run's name in the case; a problem has none");
  command.add_flag("--quick", options.quick, "A problem without the finest resolutions")
      ->excludes(run);
  add_option(command, "-o,--output", options.output, file_type,
             "Result file (default: RUN.h5 or PROBLEM.json)");
  add_state_options(command, options);
  add_option(command, "--time-limit", options.time_limit, "SECONDS",
             "Wall time after which interFoam is stopped [s]")
      ->check(keeps(positive("s")));
  add_experiments_option(command, options.experiments);
  add_option(command, "--progress-file", options.progress_file, file_type,
             "The file to which the run writes its progress");
  add_option(command, "--campaign", options.campaign, campaign_type,
             "A campaign, by name or path, whose sweeps add runs to the case");
  CLI::Option* store = add_option(
      command, "--store", options.store, directory_type,
      "Directory of results: keep the result there under its key, unless it exists already");
  command
      .add_flag("--timing", options.timing,
                "Repeat the run of the store and add the cost to its timings")
      ->needs(store);
  add_option(command, "--longest", options.longest, "SECONDS",
             "Skip a run that took more processor time [s] (default: none)")
      ->needs("--timing");
  for (const char* other : {"--output", "--snapshots", "--states", "--resume", "--time-limit"})
    store->excludes(command.get_option(other));
  for (const char* other : {"--snapshots", "--states", "--resume", "--time-limit",
                            "--progress-file", "--campaign", "--timing"})
    command.get_option(other)->needs(run);
}

// The engine of a campaign calls this command; it is hidden from users.
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

}  // namespace slosh

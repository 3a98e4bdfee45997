#include "verification/cli/command_line.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <iostream>

#include "verification/case_file/campaign_parser.hpp"
#include "verification/case_file/case_parser.hpp"
#include "verification/case_file/sweep.hpp"
#include "verification/cli/named_paths.hpp"
#include "verification/cli/stored_run.hpp"
#include "verification/display/run_display.hpp"
#include "verification/engine/run_job.hpp"
#include "verification/gate/gate.hpp"
#include "verification/results/progress_file.hpp"
#include "verification/runs/expected_cost.hpp"
#include "verification/runs/run_case.hpp"
#include "verification/runs/run_key.hpp"
#include "verification/solvers/snapshots.hpp"
#include "verification/solvers/state_file.hpp"
#include "verification/texts/run_summary.hpp"

namespace slosh {
namespace {

namespace fs = std::filesystem;

// The interval at which a run tells how far it is; the parent looks five times a second.
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
    } catch (const fs::filesystem_error&) {  // no run fails because nobody hears how far it is
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

// What repeats the run.
std::string command_of(const RunOptions& options, const Installation& installation,
                       const CaseDefinition& definition, const RunDefinition& run) {
  const std::string campaign =
      options.campaign.empty()
          ? ""
          : " --campaign " + name_or_path(find_campaign(options.campaign, installation.campaigns),
                                          installation.campaigns);
  return fmt::format(
      "./slosh run {} {} --output {}.h5{}{}", name_or_path(definition.file, installation.cases),
      run.name, run.name, campaign,
      std::holds_alternative<RecordRun>(run.solver) ? experiments_option(whole(options.experiments))
                                                    : "");
}

// Potential flow that leaves its range ends early: that is told, and it is no success.
int told_end(const RunResult& result, const CaseDefinition& definition) {
  const auto because = result.provenance.find("left_range_because");
  if (because == result.provenance.end()) return exit_pass;
  std::cerr << fmt::format("slosh: the run {} leaves its range at {:.4g} s of {:g} s: {}\n",
                           result.run_name, result.diagnostics.at("valid_until_s"),
                           definition.duration, because->second);
  return exit_not_compared;
}

// In a file of its own, with what a run leaves beside it; the exit status.
int leave_result(const RunResult& result, const fs::path& file, const RunSettings& settings,
                 const CaseDefinition& definition, const RunDefinition& run) {
  write_result(result, file);
  std::cout << run_summary(result, definition, run) << "result: " << file.string() << "\n";
  if (settings.snapshot_interval != 0)
    std::cout << "snapshots: " << snapshot_index(settings.work_directory, result.run_name).string()
              << "\n";
  if (settings.state_interval != 0)
    std::cout << "state: " << state_file(settings.work_directory, result.run_name).string() << "\n";
  return told_end(result, definition);
}

// A saved state makes the solver renew its lists: the result is not to the last bit what a campaign
// computes.
bool is_as_a_campaign_computes(const RunOptions& options) {
  return options.state_interval == 0 && options.resume.empty();
}

}  // namespace

fs::path usual_store(const Installation& installation) {
  const char* named = std::getenv(store_variable);
  return named && *named ? whole(named) : installation.build / "store";
}

int run_listed_job(std::size_t index, const std::atomic<bool>& stop) {
  run_job(JobList::open(fs::current_path()), index, stop);
  return exit_pass;  // how it has ended is in the list
}

int run_one(const RunOptions& options, const Installation& installation) {
  const fs::path experiments = whole(options.experiments);
  CaseDefinition definition =
      read_case(find_case(options.case_name, installation.cases), experiments);
  if (!options.campaign.empty())
    add_swept_runs(read_campaign(find_campaign(options.campaign, installation.campaigns),
                                 installation.cases, known_problems()),
                   experiments, definition);
  const RunDefinition& run = requested_run(definition, options.run);
  const std::string key =
      run_key(definition, run, installation.builds, installation.openfoam_templates);
  const ResultStore store(options.store);
  const fs::path file = !options.store.empty()   ? store.file(key, ".h5")
                        : options.output.empty() ? fs::path(run.name + ".h5")
                                                 : options.output;
  RunSettings settings = settings_for(options, installation, key, file);
  settings.command = command_of(options, installation, definition, run);
  const ExpectedCost expected =
      expected_cost(definition, run, key, ResultStore(usual_store(installation)));
  const auto compute = [&] {
    RunDisplay display(std::cerr, style_now_of(STDERR_FILENO), definition.name + "/" + run.name,
                       expected.wall_time);
    const Progress write = progress_writer(options.progress_file, definition.duration);
    return execute(definition, run, settings, [&](double time, double steps) {
      display.tell({time, definition.duration, steps});
      write(time, steps);
    });
  };
  // Of a run in the store the campaign judges whether it reaches its comparison window's end.
  if (options.timing) {
    time_run(store, key, options.longest, compute);
    return exit_pass;
  }
  if (!options.store.empty()) {
    keep_run(store, key, [&] {
      RunResult result = compute();
      learn_cost(result, definition, run, store);
      return result;
    });
    return exit_pass;
  }
  const RunResult result = compute();
  const int status = leave_result(result, file, settings, definition, run);
  if (is_as_a_campaign_computes(options))
    keep_copy(ResultStore(usual_store(installation)), key, result);
  return status;
}

}  // namespace slosh

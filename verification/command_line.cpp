#include "verification/command_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <iostream>

#include "verification/case_file/case_parser.hpp"
#include "verification/gate/gate.hpp"
#include "verification/named_paths.hpp"
#include "verification/runs/progress_file.hpp"
#include "verification/runs/run_case.hpp"
#include "verification/runs/run_key.hpp"
#include "verification/runs/snapshots.hpp"
#include "verification/runs/state_file.hpp"

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
    write_progress({time, end_time, steps}, file);
  };
}

}  // namespace

int run_one(const RunOptions& options, const Installation& installation) {
  const fs::path experiments = whole(options.experiments);
  const CaseDefinition definition =
      read_case(find_case(options.case_name, installation.cases), experiments);
  const auto run = std::find_if(definition.runs.begin(), definition.runs.end(),
                                [&](const RunDefinition& one) { return one.name == options.run; });
  if (run == definition.runs.end()) {
    std::string names;
    for (const RunDefinition& one : definition.runs)
      names += (names.empty() ? "" : ", ") + one.name;
    throw CaseFileError(fmt::format("{}: run = {}: expected one of {}", definition.file.string(),
                                    options.run, names));
  }
  const fs::path file = options.output.empty() ? fs::path(run->name + ".h5") : options.output;
  fs::path work = file;
  work.replace_extension(".work");
  RunSettings settings;
  settings.work_directory = work;
  settings.openfoam_templates = installation.openfoam_templates;
  settings.snapshot_interval = options.snapshot_interval;
  settings.state_interval = options.state_interval;
  settings.resume = options.resume;
  settings.key =
      run_key(definition, *run, installation.solver_build, installation.openfoam_templates);
  settings.command = fmt::format(
      "./slosh run {} {} --output {}.h5{}", name_or_path(definition.file, installation.cases),
      run->name, run->name,
      std::holds_alternative<RecordRun>(run->solver) ? experiments_option(experiments) : "");
  write_result(execute(definition, *run, settings,
                       progress_writer(options.progress_file, definition.duration)),
               file);
  std::cout << "result: " << file.string() << "\n";
  if (options.snapshot_interval != 0)
    std::cout << "snapshots: " << snapshot_index(work, run->name).string() << "\n";
  if (options.state_interval != 0)
    std::cout << "state: " << state_file(work, run->name).string() << "\n";
  return exit_pass;
}

}  // namespace slosh

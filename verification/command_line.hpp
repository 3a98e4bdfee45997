// The subcommands of the tool, but for those of campaign_command.hpp and baseline_command.hpp. Each
// takes its parsed options and returns the exit status; they
// throw CaseFileError, SolverError, ResultError and ReportError, which main.cpp turns into messages
// and exit statuses.
#pragma once

#include <filesystem>
#include <string>

namespace slosh {

// Where the tool's data lies: the source tree and its folders.
struct Installation {
  std::filesystem::path executable, solver_build, problem_build, source, cases, campaigns,
      baselines, openfoam_templates, build;
};

struct RunOptions {
  std::string case_name, run;
  std::filesystem::path output, progress_file;
  std::filesystem::path experiments;  // empty: none is named
  double snapshot_interval = 0;       // [s]
  double state_interval = 0;          // [s]
  double time_limit = 0;              // [s]; 0: none
  std::filesystem::path resume;       // empty: from the start
};

int run_one(const RunOptions& options, const Installation& installation);
int list_definitions(const Installation& installation);

}  // namespace slosh

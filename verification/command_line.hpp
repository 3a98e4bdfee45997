// Where the tool's data lies, and the subcommand run. The other subcommands stand in
// campaign_command.hpp, baseline_command.hpp, ... and in commands/, which holds the options of all.
// Each takes its parsed options and returns the exit status; they
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
  std::filesystem::path resume;       // empty: from the start
};

int run_one(const RunOptions& options, const Installation& installation);

}  // namespace slosh

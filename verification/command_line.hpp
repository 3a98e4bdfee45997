// The subcommands of the tool. Each takes its parsed options and returns the exit status; they
// throw CaseFileError, SolverError, ResultError and ReportError, which main.cpp turns into messages
// and exit statuses.
#pragma once

#include <atomic>
#include <filesystem>
#include <string>

namespace slosh {

// Where the tool's data lies: the source tree's folders.
struct Installation {
  std::filesystem::path executable, solver_build, problem_build, cases, campaigns,
      openfoam_templates, build;
};

struct CampaignOptions {
  std::string campaign;
  bool quick = false;
  bool solve = true;  // false: `slosh report`
  int at_once = 1;
  std::filesystem::path experiments;  // empty: none is named
  std::filesystem::path
      output;  // empty: <build>/campaigns/<name>, with "-quick" for the quick form
};

struct RunOptions {
  std::string case_name, run;
  std::filesystem::path output, progress_file;
  std::filesystem::path experiments;  // empty: none is named
  double snapshot_interval = 0;       // [s]
  double state_interval = 0;          // [s]
  std::filesystem::path resume;       // empty: from the start
};

struct ProblemOptions {
  std::string problem;
  bool quick = false;
  std::filesystem::path output;  // empty: NAME.json
};

int run_campaign(const CampaignOptions& options, const Installation& installation,
                 const std::atomic<bool>& stop);
int run_one(const RunOptions& options, const Installation& installation);
int run_problem(const ProblemOptions& options, const Installation& installation);
int list_definitions(const Installation& installation);

}  // namespace slosh

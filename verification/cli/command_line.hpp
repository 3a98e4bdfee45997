// Where the tool's data lies, and the subcommand run. The other subcommands stand beside this file.
// Each takes its parsed options and returns the exit status. They throw CaseFileError, SolverError,
// ResultError and ReportError, which main.cpp turns into messages and exit statuses.
#pragma once

#include <atomic>
#include <cstddef>
#include <filesystem>
#include <limits>
#include <string>

namespace slosh {

// Where the tool's data lies: the source tree and its folders.
struct Installation {
  std::filesystem::path executable, builds, source, cases, campaigns, baselines, openfoam_templates,
      build;
};

inline constexpr const char* store_variable = "SLOSH_STORE";

// Of the results that campaigns share: what the environment says, or else build/store.
std::filesystem::path usual_store(const Installation& installation);

struct RunOptions {
  std::string case_name, run;
  std::filesystem::path output, progress_file;
  std::filesystem::path experiments;  // empty: none is named
  std::filesystem::path campaign;     // a name or path: with the runs of its sweeps; or empty
  // The result goes there alone, under its key; empty: to the output, and a copy to usual_store().
  std::filesystem::path store;
  bool timing = false;                                       // only its timing, into the store
  double longest = std::numeric_limits<double>::infinity();  // [s], of a run that is timed
  double snapshot_interval = 0;                              // [s]
  double state_interval = 0;                                 // [s]
  double time_limit = 0;                                     // [s]; 0: none
  std::filesystem::path resume;                              // empty: from the start
};

// Runs job `index` of the list in the current directory (engine/job_list.hpp): what an engine
// starts.
int run_listed_job(std::size_t index, const std::atomic<bool>& stop);

int run_one(const RunOptions& options, const Installation& installation);

}  // namespace slosh

// What a run leaves: one HDF5 file, written under a temporary name and renamed when complete. Everything
// after it (metrics, gate, report) can be redone without running a solver. The README documents the layout.
#pragma once

#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "verification/metrics/time_series.hpp"

namespace slosh {

// What the run took, in the operating system's figures for its process and its children.
struct RunCost {
  double wall_time = 0;     // [s]
  double user_time = 0;     // [s], all threads and children
  double system_time = 0;   // [s]
  double peak_memory = 0;   // [byte], largest single process
  double steps = 0;
  double elements = 0;      // particles (walls apart) or cells
};

struct RunResult {
  std::string case_name, run_name, solver;
  std::string case_text;    // the case file as read
  std::string key;          // hash of all that determined the run
  std::map<std::string, std::string> provenance;  // versions, compiler, host's processor, time of the run, command
  std::vector<std::string> active_terms;          // the physics compiled in or switched on
  std::map<std::string, double> diagnostics;      // "max_courant_number", "mass_loss", ... (unit in the name)
  RunCost cost;
  std::vector<TimeSeries> series;

  // Throws ResultError when there is no such series.
  const TimeSeries& at(const std::string& series_name) const;
};

// A result file that is absent, truncated, altered, of another version, or that could not be written.
struct ResultError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

void write_result(const RunResult& result, const std::filesystem::path& file);
RunResult read_result(const std::filesystem::path& file);

}  // namespace slosh

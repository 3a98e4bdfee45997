// The process of an external program: started without a shell, ended when its time is over or when
// this process is told to end, and judged by how it ends and by what its log says.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "verification/solvers/solver_runs.hpp"

namespace slosh {

struct ProgramStart {
  std::vector<std::string> command;
  std::filesystem::path directory;        // in which it is started
  std::filesystem::path log;              // gets its output and errors
  std::optional<double> time_limit = {};  // [s] of wall time
  std::optional<int> cores = {};          // to which it is bound, and its number of OpenMP threads
};

// Throws SolverError unless the program ends by itself, in time and with status 0.
void run_program(const ProgramStart& start);

// Throws SolverError with the first line of the log that one of these regular expressions matches.
void require_no_match(const std::vector<std::string>& fail_on, const std::filesystem::path& log);

// Returns the error with one line that says what went wrong, as reports show it, and the end of the
// program's log.
SolverError program_failure(const std::string& what, const std::filesystem::path& log);

}  // namespace slosh

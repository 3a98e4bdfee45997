// Why a run or a problem failed, as data: a sealed JSON file (sealed_json.hpp) that lies in the
// store where the result would (result_store.hpp) until the run is tried again.
#pragma once

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>

namespace slosh {

inline constexpr const char* failure_extension = ".failure.json";

struct RunFailure {
  std::string kind;     // "solver failed", "killed", "time limit", "not started", "lost", ...
  std::string message;  // one line
  std::string details;  // the failed program's own words, line by line; empty where it left none
  std::string log;      // the file that has all of them; empty where there is none
};

// Throws ResultError.
void write_failure(const RunFailure& failure, const std::filesystem::path& file);

// Nothing where the file is absent, altered, or no such file.
std::optional<RunFailure> read_failure(const std::filesystem::path& file);

// The solver failed, could not use its directories, or left less than the whole duration or values
// that are no numbers. what() says how.
struct SolverError : std::runtime_error {
  explicit SolverError(const std::string& message)
      : SolverError({"solver failed", message, "", ""}) {}
  // what() is the message, the log in brackets, and the details below.
  explicit SolverError(const RunFailure& why);

  RunFailure failure;
};

}  // namespace slosh

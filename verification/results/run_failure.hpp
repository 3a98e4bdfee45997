// The reason why a run or a problem failed, as a sealed JSON file (sealed_json.hpp). It lies in the
// store in the place of the result (result_store.hpp) until the run is tried again.
#pragma once

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>

namespace slosh {

inline constexpr const char* failure_extension = ".failure.json";

struct RunFailure {
  std::string kind;     // "solver failed", "killed", "time limit", "lost", ...
  std::string message;  // one line
  std::string details;  // the failed program's last output; empty where it left none
  std::string log;      // the file with its whole output; empty where there is none
};

// Throws ResultError.
void write_failure(const RunFailure& failure, const std::filesystem::path& file);

// Returns nullopt where the file is absent. A file that cannot be read tells of a failure too: its
// message says why it cannot.
std::optional<RunFailure> read_failure(const std::filesystem::path& file);

// The solver failed, could not use its directories, or left series that end early or hold NaN or
// infinite values. what() says how.
struct SolverError : std::runtime_error {
  explicit SolverError(const std::string& message)
      : SolverError({"solver failed", message, "", ""}) {}
  // what() is the message, the log in brackets, and the details below.
  explicit SolverError(const RunFailure& why);

  RunFailure failure;
};

}  // namespace slosh

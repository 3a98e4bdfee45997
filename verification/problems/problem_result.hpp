// The result of a problem: one sealed JSON file (sealed_json.hpp) whose body has `format` ("slosh
// problem"), `format_version` and the members below by their names, null for NaN.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "verification/problems/problem_list.hpp"
#include "verification/results/result_file.hpp"

namespace slosh {

struct ProblemResult {
  std::string problem;
  bool quick = false;
  std::string key;
  std::map<std::string, std::string> provenance;
  RunCost cost;  // without steps and elements
  ProblemOutcome outcome;
};

// Returns "<32 digits>-<32 digits>": the hash of the problem and its form, then that of the file in
// `builds` (solver_builds.cmake) that changes with the code of the problems. Throws
// std::filesystem::filesystem_error where that file cannot be read.
std::string problem_key(const Problem& problem, bool quick, const std::filesystem::path& builds);

// Writes the file. Throws ResultError.
void write_problem_result(const ProblemResult& result, const std::filesystem::path& file);

// Reads the file. Throws ResultError for a file that is absent, truncated, altered or of another
// version.
ProblemResult read_problem_result(const std::filesystem::path& file);

}  // namespace slosh

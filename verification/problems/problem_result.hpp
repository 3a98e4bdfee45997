// What a problem leaves: one sealed JSON file (sealed_json.hpp) whose body has
//   format ("slosh problem"), format_version, problem, quick, key, provenance, cost, measures[]
//   (name, errors[]: step and error, null for no number), figures[] (id, title, caption, x_label,
//   y_label, log_x, log_y, curves[]), tables[] (id, title, caption, header, rows[])
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "verification/problems/problem.hpp"
#include "verification/results/result_file.hpp"

namespace slosh {

struct ProblemResult {
  std::string problem;
  bool quick = false;
  std::string key;
  std::map<std::string, std::string> provenance;
  RunCost cost;  // but for steps and elements
  ProblemOutcome outcome;
};

// "<32 digits>-<32 digits>": the problem and its form, then the content of the file in `builds`
// (solver_builds.cmake) that changes with the code that answers it. Throws
// std::filesystem::filesystem_error where that cannot be read.
std::string problem_key(const Problem& problem, bool quick, const std::filesystem::path& builds);

// Throws ResultError.
void write_problem_result(const ProblemResult& result, const std::filesystem::path& file);

// Throws ResultError for a file that is absent, truncated, altered or of another version.
ProblemResult read_problem_result(const std::filesystem::path& file);

}  // namespace slosh

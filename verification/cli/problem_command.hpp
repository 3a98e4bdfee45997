// The subcommand problem: one verification problem, solved in this process.
#pragma once

#include <filesystem>
#include <string>

#include "verification/cli/command_line.hpp"

namespace slosh {

struct ProblemOptions {
  std::string problem;
  bool quick = false;
  std::filesystem::path output;  // empty: NAME.json
  std::filesystem::path store;   // the result goes there, under its key; empty: to the output
};

// Throws as the commands of command_line.hpp do.
int run_problem(const ProblemOptions& options, const Installation& installation);

}  // namespace slosh

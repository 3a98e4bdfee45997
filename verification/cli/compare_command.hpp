// The subcommand compare: two result files set against one another on one quantity, with or without
// a case, and judged where limits are given. Throws CaseFileError for what the command line makes
// impossible, ResultError and ComparisonError where there is nothing to compare.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "verification/cli/command_line.hpp"

namespace slosh {

struct CompareOptions {
  std::filesystem::path candidate, reference;  // result files
  std::string gauge, quantity;                 // at most one of the two
  std::string case_name;                       // empty: none
  std::vector<double> frequencies;             // [Hz], of the modes to fit where no case tells
  std::vector<double> window;       // [s] begin and end; empty: see docs/other_solvers.md
  std::vector<std::string> limits;  // "METRIC=VALUE", "MODE:METRIC=VALUE"
  std::filesystem::path json;       // empty: none
};

int compare_results(const CompareOptions& options, const Installation& installation);

}  // namespace slosh

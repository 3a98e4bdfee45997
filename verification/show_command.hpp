// The subcommand show: a picture of a case's histories, of the results that there are. Throws
// CaseFileError for what the command line makes impossible, ResultError where there is nothing to
// show, and ReportError where it cannot be drawn.
#pragma once

#include <filesystem>
#include <string>

#include "verification/command_line.hpp"

namespace slosh {

struct ShowOptions {
  std::string case_name;
  std::string quantity;               // of the picture; empty: the one that the case is about
  std::filesystem::path output;       // .png, .svg or .html; empty: a page, shown by a browser
  std::filesystem::path store;        // of the results
  std::filesystem::path experiments;  // empty: none is named
};

int show_case(const ShowOptions& options, const Installation& installation);

}  // namespace slosh

// The subcommand import: series out of another program's file into a result file. Throws
// CaseFileError for what the command line or the file's head makes impossible, ResultError for
// numbers that cannot be used.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace slosh {

struct ImportOptions {
  std::filesystem::path file, output;
  std::string format;
  std::vector<std::string> series;  // "QUANTITY=COLUMN" each
  std::string unit, time_column, time_unit;
  double scale = 1, offset = 0;  // offset in the quantity's unit
};

int import_file(const ImportOptions& options);

}  // namespace slosh

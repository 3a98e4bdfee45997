// Reads the peak pressures of repeated impact experiments in the format of SPHERIC benchmark 10: a
// title line that names the unit mbar, a header line, and a row for each run with the peaks of its
// first four impacts, separated by tabs or blanks.
#pragma once

#include <array>
#include <filesystem>
#include <vector>

#include "verification/input/case_file_error.hpp"

namespace slosh {

struct PeakTable {
  // [Pa], for each impact the peaks of the runs, in the order of the file.
  std::array<std::vector<double>, 4> impacts;
};

// Throws CaseFileError with the table's file:line if the file cannot be read, if the title does not
// name mbar, if there is no header, if a row is not four finite numbers, or if there are fewer than
// two runs.
PeakTable read_peak_table(const std::filesystem::path& file);

}  // namespace slosh

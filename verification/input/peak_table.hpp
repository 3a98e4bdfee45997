// The peak pressures of repeated impact runs in the form in which SPHERIC benchmark 10 publishes
// them: a title line that names the unit mbar, a header line, then a row for each run of four
// numbers, the peaks of its first four impacts, separated by tabs or blanks.
#pragma once

#include <array>
#include <filesystem>
#include <vector>

#include "verification/input/case_file_error.hpp"

namespace slosh {

struct PeakTable {
  // [Pa], per impact the peak of each run, runs in the file's order.
  std::array<std::vector<double>, 4> impacts;
};

// Throws CaseFileError with the table's own file:line when the file cannot be read, the title names
// no mbar, there is no header, a row is not four finite numbers or there are fewer than two runs.
PeakTable read_peak_table(const std::filesystem::path& file);

}  // namespace slosh

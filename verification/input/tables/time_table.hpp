// Reads tables of values over time: the project's own with the columns "time_s" and another whose
// name ends in its unit (a tank's motion, a published record), and those of other origin, whose
// columns the caller names. Their text may be as that of any program (table_head.hpp).
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "verification/input/case_file_error.hpp"
#include "verification/input/tables/table_head.hpp"

namespace slosh {

// Reads the peak pressures of repeated impact experiments in the format of SPHERIC benchmark 10: a
// title line that names the unit mbar, a header line, and a row for each run with the peaks of its
// first four impacts, separated by tabs or blanks.

struct PeakTable {
  // [Pa], for each impact the peaks of the runs, in the order of the file.
  std::array<std::vector<double>, 4> impacts;
};

// Throws CaseFileError with the table's file:line if the file cannot be read, if the title does not
// name mbar, if there is no header, if a row is not four finite numbers, or if there are fewer than
// two runs.
PeakTable read_peak_table(const std::filesystem::path& file);

struct TimeTable {
  std::string column;               // the value's name
  std::vector<double> time, value;  // [s] and the column's unit
  std::vector<int> lines;           // of the rows, for messages
};

// The columns to read, by their names in the file. The times are in the unit that their column
// gives, else in s.
struct TimeColumns {
  std::string time, value;
  ToldUnit unit;  // of the values
};

// Both throw CaseFileError with the table's file:line unless it has at least four rows (a spline
// needs them), finite numbers and strictly increasing times.

// Reads "time_s" and the one that the file has of the columns given. A name may have its unit in
// brackets: "time [s]" is "time_s".
TimeTable read_time_table(const std::filesystem::path& file,
                          const std::vector<std::string>& columns);
// Reads two columns of a file with any columns. Throws CaseFileError too where the file gives
// another unit than the told one.
TimeTable read_time_columns(const std::filesystem::path& file, const TimeColumns& columns);

}  // namespace slosh

// Reads CSV files of values over time: the project's own with the columns "time_s" and another
// whose name ends in its unit (a tank's motion, a published record), and files of other origin,
// whose columns the caller names.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "verification/input/case_file_error.hpp"
#include "verification/input/table_reader.hpp"

namespace slosh {

struct TimeTable {
  std::string column;               // the value's name
  std::vector<double> time, value;  // [s] and the column's unit; the first row is on line 2
};

// The columns to read, by their names in the first line of the file.
struct TimeColumns {
  std::string time, value;
  std::string value_unit;  // for messages
};

// Both throw CaseFileError with the CSV file's file:line unless the table has at least four rows (a
// spline needs them), finite numbers and strictly increasing times.

// Reads a file of two columns: "time_s" and one of those given.
TimeTable read_time_table(const std::filesystem::path& file,
                          const std::vector<std::string>& columns);
// Reads two columns of a file with any columns.
TimeTable read_time_columns(const std::filesystem::path& file, const TimeColumns& columns);

}  // namespace slosh

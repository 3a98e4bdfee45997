// CSV files of values over time: the project's own of two columns, "time_s" and one more whose name
// ends in its unit (a tank's motion, a published record), and tables of others, whose columns are
// told.
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

// Which of a file's columns are read, by their names in its first line.
struct TimeColumns {
  std::string time, value;
  std::string value_unit;  // for messages
};

// Both: at least four rows (what a spline needs), the numbers finite, times strictly increasing.
// Throw CaseFileError with the CSV file's own file:line.

// Of two columns, the second one of those given.
TimeTable read_time_table(const std::filesystem::path& file,
                          const std::vector<std::string>& columns);
// Of any columns, of which two are read.
TimeTable read_time_columns(const std::filesystem::path& file, const TimeColumns& columns);

}  // namespace slosh

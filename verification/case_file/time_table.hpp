// A CSV file of two columns, "time_s" and one more whose name ends in its unit: a tank's motion, a
// published record.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "verification/case_file/case_file_error.hpp"

namespace slosh {

struct TimeTable {
  std::string column;               // the second one's name
  std::vector<double> time, value;  // [s] and the column's unit; the first row is on line 2
};

// At least four rows (what a spline needs), all numbers finite, times strictly increasing, the
// second column one of those given. Throws CaseFileError with the CSV file's own file:line.
TimeTable read_time_table(const std::filesystem::path& file,
                          const std::vector<std::string>& columns);

// What is wrong on a line of a table.
CaseFileError table_error(const std::filesystem::path& file, int line, std::string_view key,
                          std::string_view value, std::string_view expected);

}  // namespace slosh

// Reads the series that function objects left, and refuses what is not a whole, sound one.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "openfoam_cases/sloshing_tank.hpp"

namespace slosh::openfoam {

// Throws RunError for this file.
[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& what);

// The numbers of a row, vectors' parentheses left out; empty where anything else stands in it.
std::vector<double> numbers_in(std::string row);

// Where a function object wrote the file of this name.
std::filesystem::path series_file(const std::filesystem::path& case_directory,
                                  const std::string& function_object, const char* name);

struct Rows {
  std::vector<double> time;
  std::vector<std::vector<double>> values;  // what follows the time, by row
};

// Rows of a time and `columns` - 1 values. Throws RunError for a missing file, a number that is not
// finite, a row of another length, and samples that do not come at every interval up to the end.
Rows read_rows(const SloshingTank& tank, const std::filesystem::path& file, std::size_t columns);

// The first value of each row.
History read_series(const SloshingTank& tank, const std::filesystem::path& file,
                    std::size_t columns);

}  // namespace slosh::openfoam

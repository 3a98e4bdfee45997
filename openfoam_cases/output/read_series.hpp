// Reads the time series that function objects wrote.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "openfoam_cases/sloshing_tank.hpp"

namespace slosh::openfoam {

struct History {
  std::vector<double> time, value;
};

// Returns the numbers of a row without the parentheses of vectors; empty where the row contains
// anything else.
std::vector<double> numbers_in(std::string row);

// Returns where a function object writes the file of this name.
std::filesystem::path series_file(const std::filesystem::path& case_directory,
                                  const std::string& function_object, const char* name);

struct Rows {
  std::vector<double> time;
  std::vector<std::vector<double>> values;  // [row][column after the time]
};

// Reads rows of a time and `columns` - 1 values. Throws RunError for a missing file, a number that
// is not finite, a row of another length, and samples that do not come at every interval up to the
// end.
Rows read_rows(const SloshingTank& tank, const std::filesystem::path& file, std::size_t columns);

// Returns the first value of each row; throws as read_rows() does.
History read_series(const SloshingTank& tank, const std::filesystem::path& file,
                    std::size_t columns);

}  // namespace slosh::openfoam

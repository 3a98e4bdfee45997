// A tank's motion as a table: a CSV file whose first line is "time_s,displacement_m".
#pragma once

#include <filesystem>

#include "verification/case_file/case_definition.hpp"

namespace slosh {

// At least four rows, times strictly increasing from 0 to at least the case's duration [s]. Throws
// CaseFileError with the CSV file's own file:line.
TableSurge read_surge_table(const std::filesystem::path& file, double duration);

}  // namespace slosh

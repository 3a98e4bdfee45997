// The series of a result file as one table.
#pragma once

#include <string>

#include "verification/results/result_file.hpp"

namespace slosh {

// Comma-separated values: a line of heads, "time [s],elevation@right [m],...", then a line for each
// moment at which any series has a value; empty where a series has none then. Each number reads as
// the very one in the file. Throws ResultError for times that do not increase.
std::string series_csv(const RunResult& result);

}  // namespace slosh

// Writes the series of a result file as one table.
#pragma once

#include <string>

#include "verification/results/result_file.hpp"

namespace slosh {

// Returns comma-separated values: a header, "time [s],elevation@right [m],...", and a line for each
// time at which any series has a value. A cell is empty if its series has no value then. Every
// number can be read back without loss. Throws ResultError for times that do not increase.
std::string series_csv(const RunResult& result);

}  // namespace slosh

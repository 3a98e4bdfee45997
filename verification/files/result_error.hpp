// The error of files that this project writes and reads again.
#pragma once

#include <stdexcept>

namespace slosh {

// A result file, or another file that the project keeps, is missing, truncated, altered, of another
// version, or could not be written.
struct ResultError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace slosh

// The one exception of everything that the user writes: case files, campaign files, motion tables.
#pragma once

#include <stdexcept>

namespace slosh {

// The user's file is wrong; what() is the whole message, "file:line: key = value: expected ...".
struct CaseFileError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace slosh

// The one exception of everything that the user writes: case files, campaign files, motion tables.
#pragma once

#include <stdexcept>
#include <string>

namespace slosh {

// Where a value was written, for messages and for reports that point at a row.
struct SourceLocation {
  std::string file;
  int line = 0;
};

// The user's file is wrong; what() is the whole message, "file:line: key = value: expected ...".
struct CaseFileError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace slosh

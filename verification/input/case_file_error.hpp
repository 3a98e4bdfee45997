// What is wrong with anything that the user writes: case files, campaign files and tables.
#pragma once

#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace slosh {

// Where a value is written, for messages and for reports that point at a gate row.
struct SourceLocation {
  std::string file;
  int line = 0;
};

// The user's file is wrong; what() is the whole message, "file:line: key = value: expected ...".
struct CaseFileError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Several mistakes; what() holds one message per line.
struct CaseFileErrors : CaseFileError {
  explicit CaseFileErrors(std::vector<std::string> all);

  std::vector<std::string> messages;
};

// Collects the mistakes of a file, so that they are reported together. A mistake that shows in
// several places, such as in every row of a group, is kept once.
class Complaints {
 public:
  // Further mistakes are reported once these are corrected.
  static constexpr std::size_t most = 20;

  // Returns whether `read` ends without a CaseFileError, and keeps one that it throws. Throws
  // CaseFileErrors as soon as `most` messages are kept.
  bool allow(const std::function<void()>& read);

  // Throws CaseFileErrors if any message is kept.
  void tell() const;

 private:
  void keep(const std::string& message);

  std::vector<std::string> messages_;
};

}  // namespace slosh

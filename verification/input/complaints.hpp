// All that is wrong with what a user wrote, told at once.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "verification/input/case_file_error.hpp"

namespace slosh {

// what() has a message a line.
struct CaseFileErrors : CaseFileError {
  explicit CaseFileErrors(std::vector<std::string> all);

  std::vector<std::string> messages;
};

class Complaints {
 public:
  // More are told when these are gone.
  static constexpr std::size_t most = 20;

  // Whether `read` ends without a CaseFileError; one that it throws is kept. Throws what is kept
  // once that is `most`.
  bool allow(const std::function<void()>& read);

  // Throws CaseFileErrors where anything is kept.
  void tell() const;

 private:
  std::vector<std::string> messages_;
};

}  // namespace slosh

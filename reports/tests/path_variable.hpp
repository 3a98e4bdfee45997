// The PATH variable changed for the life of an object.
#pragma once

#include <cstdlib>
#include <string>

namespace slosh::reports {

class PathVariable {
 public:
  explicit PathVariable(const std::string& value) {
    if (const char* now = std::getenv("PATH")) before_ = now;
    setenv("PATH", value.c_str(), 1);
  }
  ~PathVariable() { setenv("PATH", before_.c_str(), 1); }
  PathVariable(const PathVariable&) = delete;
  PathVariable& operator=(const PathVariable&) = delete;

 private:
  std::string before_;
};

}  // namespace slosh::reports

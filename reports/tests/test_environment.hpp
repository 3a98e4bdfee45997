// An empty directory and a changed PATH for one test.
#pragma once

#include <stdlib.h>

#include <filesystem>
#include <string>

#include "reports/model/report_files.hpp"

namespace slosh::reports {

// An empty directory, which is removed with the object.
class ScratchDirectory : public TemporaryDirectory {
 public:
  ScratchDirectory()
      : TemporaryDirectory((std::filesystem::temp_directory_path() / "slosh-reports-").string()) {}

  std::filesystem::path operator/(const std::string& name) const { return path() / name; }
};

// The PATH variable, changed for the life of the object.
class PathVariable {
 public:
  explicit PathVariable(const std::string& value) {
    if (const char* now = getenv("PATH")) before_ = now;
    setenv("PATH", value.c_str(), 1);
  }
  ~PathVariable() { setenv("PATH", before_.c_str(), 1); }
  PathVariable(const PathVariable&) = delete;
  PathVariable& operator=(const PathVariable&) = delete;

 private:
  std::string before_;
};

}  // namespace slosh::reports

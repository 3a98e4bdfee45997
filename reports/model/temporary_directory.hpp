// A directory for what is drawn or written on the way.
#pragma once

#include <filesystem>
#include <string>

namespace slosh::reports {

// A new directory of its own, gone with the object.
class TemporaryDirectory {
 public:
  // Its path is `name_start` and six letters. Throws ReportError where it cannot be made.
  explicit TemporaryDirectory(const std::string& name_start);
  ~TemporaryDirectory();
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace slosh::reports

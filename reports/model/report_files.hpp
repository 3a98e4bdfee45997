// Whole text files, with errors that name the file, and a directory for temporary ones.
#pragma once

#include <filesystem>
#include <string>

namespace slosh::reports {

// Both throw ReportError with the path and the system's reason.
std::string read_text(const std::filesystem::path& path);
void write_text(const std::filesystem::path& path, const std::string& text);

// A new directory, which is removed with the object.
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
